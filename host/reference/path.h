#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/bsdf.h"
#include "reference/random.h"
#include "scene/scene.h"
#include "settings/transport.h"

namespace calotype::reference {

class Geometry;
class Lights;

/// What all paths of a picture share.
struct PathSetup {
    const Scene& scene;
    const std::vector<Texture>& textures; ///< read in place of those of the scene
    const Geometry& geometry;
    const Lights& lights;
    glm::uvec2 imageSize; ///< of the whole film, pixels
    uint32_t maxBounces;  ///< scattering events along a path, at most
    TransportSettings transport;
    LobesOf lobesOf = lobesOfMaterial;
};

/// One sample of one pixel.
struct PathSample {
    glm::dvec3 radiance{0.0}; ///< W/(m^2 sr)
    uint32_t rays = 0;
    bool showsNothing = false; ///< the background, which is hidden from the camera
    bool isFinite = true;      ///< of the radiance, and of the path's throughput at its end
};

/// Follows a light path from the camera, event by event. May be called from several threads.
PathSample tracePath(const PathSetup& setup, const SampleId& id);

} // namespace calotype::reference
