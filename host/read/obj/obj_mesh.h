#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "math/affine_transform.h"
#include "mesh/displacement.h"
#include "mesh/mesh_builder.h"
#include "read/obj/obj_cache.h"
#include "read/obj/obj_file.h"
#include "read/read_context.h"

namespace calotype {

/// The OBJ file at `path`, of `cache` or read now. Throws SceneError at `where` if it cannot be
/// read. Warns of polygons that cannot be cut properly.
std::shared_ptr<const ObjFile> readObj(const std::string& path, const std::string& where,
                                       ObjCache& cache, ReadContext& context);

/// What else a mesh of an OBJ is made from.
struct ObjMeshInput {
    std::string path;  ///< of the OBJ, for warnings
    std::string where; ///< for errors
    /// The index in Scene::materials of each of ObjFile::materialNames and, last, of faces without
    /// a material; or one for all.
    std::vector<uint32_t> materials;
    /// By index in Scene::materials.
    std::span<const std::optional<Displacement>> displacements;
    AffineTransform worldFromObject;
    NormalMode normals = NormalMode::Auto;
};

/// The OBJ as a mesh in world space, displaced. Warns where textures are read but texture
/// coordinates missing, and of triangles without an area, which are left out.
Mesh buildObjMesh(const ObjFile& obj, const ObjMeshInput& input, ReadContext& context);

} // namespace calotype
