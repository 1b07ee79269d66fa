#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "math/affine_transform.h"
#include "mesh/displacement.h"
#include "mesh/mesh_builder.h"
#include "read/obj/obj_cache.h"
#include "read/obj/obj_file.h"
#include "read/read_context.h"

namespace calotype {

/// Starts to read the OBJ file at `path`, or one of another format, on another thread.
void startObj(const std::string& path, ObjCache& cache, ReadContext& context);

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
    /// By index in Scene::materials; empty if none of `materials` is displaced.
    std::vector<std::optional<Displacement>> displacements;
    AffineTransform worldFromObject;
    NormalMode normals = NormalMode::Auto;
};

struct BuiltObjMesh {
    MeshAndDropped mesh;
    std::set<uint32_t> lackingUvs; ///< materials of triangles without texture coordinates
};

/// A mesh that is being built.
struct BegunObjMesh {
    std::shared_ptr<const ObjMeshInput> input;
    std::shared_ptr<TaskOf<BuiltObjMesh>> task;
};

/// Starts to build the OBJ as a mesh in world space, displaced, on another thread.
BegunObjMesh beginObjMesh(std::shared_ptr<const ObjFile> obj, ObjMeshInput input,
                          ReadContext& context);

/// The mesh. Warns if textures are used but texture coordinates are missing, and of triangles
/// without an area, which are left out. Throws SceneError like displace and buildMesh.
Mesh finishObjMesh(const BegunObjMesh& begun, ReadContext& context);

} // namespace calotype
