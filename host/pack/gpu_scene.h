#pragma once

#include <optional>
#include <span>
#include <vector>

#include "accel/bvh.h"
#include "accel/primitive.h"
#include "pack/scene_features.h"
#include "pack/texel_rows.h"
#include "scene/scene.h"
#include "settings/light_choice.h"
#include "shared/scene_structs.h"

namespace calotype {

/// A scene in the form that the kernels read, relative to `origin`. No array is empty.
struct GpuScene {
    // The arrays of shared/binding_table.h: `nodes`, `triangles`, `triangleNormals`, ... There are
    // as many normals and texture coordinates as triangles, or a single unused one. Unused
    // materials are left blank. Texels are those of the scene's images.
#define BEGIN_BINDINGS
#define SCENE_ARRAY(id, type, member, people) SCENE_ROWS(id, shared::type, member, people)
#define SCENE_ROWS(id, type, member, people) std::vector<type> member;
#define BINDING(id)
#define END_BINDINGS
#include "shared/binding_table.h"
    uint32_t lightCount = 0;                ///< if 0, `lights` holds one unused light
    uint32_t infiniteLight = shared::kNone; ///< index of the light of rays that hit no surface
    uint32_t lightTreeDepth = 0;            ///< most nodes above a light; 0: no tree chooses lights
    size_t primitiveCount = 0;
    shared::Camera camera{};
    SceneFeatures features;
    glm::dvec3 origin{0.0};
    double maxRadiance = 0.0; ///< largest emitted radiance of any channel, W/(m^2 sr)

    /// Bytes on the device.
    size_t bytes() const;

    /// Bytes of the largest array.
    size_t largestBytes() const;
};

/// What to pack in addition to what the scene needs.
struct PackOptions {
    bool allUvs = false;     ///< texture coordinates of triangles without textures
    bool allNormals = false; ///< normals of flat triangles: zeros
    LightChoice lightChoice = LightChoice::Power;
    std::optional<TextureFilter> textureFilter = {}; ///< of all textures; none: each its own
};

/// Packs a scene with its BVH. `aspectRatio` is the picture's width over its height; `primitives`
/// were collected relative to `origin`.
GpuScene packScene(const Scene& scene, std::span<const Primitive> primitives, const Bvh& bvh,
                   const glm::dvec3& origin, double aspectRatio, const PackOptions& options = {});

} // namespace calotype
