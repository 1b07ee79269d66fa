#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "math/bounds.h"
#include "scene/scene.h"

namespace calotype {

/// Where some lights are, to which directions they shine, and how strongly. Light leaves a surface
/// to all directions on its lit side.
struct LightCluster {
    Bounds3d bounds;                ///< of all points of the lights, metres
    glm::dvec3 axis{0.0, 1.0, 0.0}; ///< unit length
    double thetaO = 0.0;            ///< radians, in [0, pi]: every normal of a lit side is within
                                    ///< this angle of the axis
    bool isTwoSided = false;        ///< or of the opposite of the axis
    double power = 0.0;             ///< luminance(Le) area sides, W/sr

    /// Metres.
    glm::dvec3 center() const { return 0.5 * (bounds.lower + bounds.upper); }
};

/// The smallest cluster known to hold both: the cone of normals is that of two cones (Conty Estevez
/// and Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting", algorithm 1).
LightCluster joined(const LightCluster& a, const LightCluster& b);

/// A primitive that emits.
struct PrimitiveLight {
    uint32_t primitive = 0; ///< its number in the order of the scene file
    LightCluster cluster;
};

/// All primitives that emit light, in the order of the scene file: not those without area.
std::vector<PrimitiveLight> primitiveLights(const Scene& scene);

/// Whether more than `count` primitives have a material that emits.
bool hasMorePrimitiveLightsThan(uint32_t count, const Scene& scene);

} // namespace calotype
