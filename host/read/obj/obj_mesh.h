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

/// The OBJ file at `path`, or a file of another format (read/mesh_formats.h) in this form, from
/// `cache` if it was read before. Throws SceneError at `where` if it cannot be read. Warns of
/// polygons that cannot be triangulated exactly.
std::shared_ptr<const ObjFile> readObj(const std::string& path, const std::string& where,
                                       ObjCache& cache, ReadContext& context);

/// Further inputs for a mesh of an OBJ.
struct ObjMeshInput {
    std::string path;  ///< of the OBJ, for warnings
    std::string where; ///< for errors
    /// The index in Scene::materials for each of ObjFile::materialNames and, last, for faces
    /// without a material; or one index for all.
    std::vector<uint32_t> materials;
    /// By index in Scene::materials.
    std::span<const std::optional<Displacement>> displacements;
    AffineTransform worldFromObject;
    NormalMode normals = NormalMode::Auto;
};

/// The OBJ as a mesh in world space, displaced. Warns if textures are used but texture coordinates
/// are missing, and of triangles without an area, which are left out.
Mesh buildObjMesh(const ObjFile& obj, const ObjMeshInput& input, ReadContext& context);

} // namespace calotype
