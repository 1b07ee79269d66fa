#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "mesh/object_mesh.h"
#include "scene/scene.h"

namespace calotype {

/// Moves the positions of a mesh by `scale * (value - mid)` along their normals.
struct Displacement {
    /// One triangle becomes 4^12 at this limit, the most for any mesh.
    static constexpr uint32_t kMostSubdivisions = 12;

    uint32_t texture = 0;   ///< index into Scene::textures, read by lookUpScalar
    double scale = 0.0;     ///< in units of object space
    double mid = 0.0;       ///< the value that moves nothing
    uint32_t subdivide = 0; ///< times that each triangle is split into four
    std::string place;      ///< file and JSON pointer of "subdivide", for messages
};

/// The limit on triangles that subdivision may make of one mesh. Each needs about 175 bytes of
/// memory until the mesh is in the scene (measured): less than 3 GiB in all.
constexpr uint64_t kMostDisplacedTriangles = uint64_t{1} << 24;

/// Whether displaced triangles get the normals of the displaced surface. Without them their normals
/// are of no use: for meshes whose normals are made later.
enum class SurfaceNormals : uint8_t { Made, LeftOut };

/// The mesh in object space, subdivided and displaced; nullopt if no triangle has a displaced
/// material. `ofMaterial` is indexed by Mesh::Triangle::material; materials beyond its end are not
/// displaced.
///
/// The whole mesh is subdivided, as often as the largest `subdivide`, so that it stays watertight.
/// Each position (by value; its indices do not matter) moves along the area-weighted normal of the
/// undisplaced mesh. Its height is the mean over the distinct pairs of displacement and texture
/// coordinates of the triangles there. Triangles that are not displaced count together as one
/// height of zero; missing texture coordinates count as (0, 0). A position whose normals cancel
/// does not move. Displaced triangles have shading normals of the displaced surface (area-weighted
/// per position), and so do the corners that other triangles share with them. A triangle that is
/// not displaced and has no normals stays flat.
///
/// Throws SceneError at the displacement's place if subdivision would make more than
/// kMostDisplacedTriangles, before it allocates memory. `name` is the mesh's, for that message.
std::optional<Mesh> displace(const ObjectMesh& mesh,
                             std::span<const std::optional<Displacement>> ofMaterial,
                             std::span<const Texture> textures, const std::string& name,
                             SurfaceNormals normals = SurfaceNormals::Made);

} // namespace calotype
