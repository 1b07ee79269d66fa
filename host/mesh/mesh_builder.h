#pragma once

#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "math/affine_transform.h"
#include "mesh/object_mesh.h"
#include "scene/scene.h"

namespace calotype {

/// The source of a mesh's shading normals.
enum class NormalMode {
    Auto,   ///< as given; flat where there are none
    Smooth, ///< at each position the mean of its triangles, weighted by area
    Flat,
};

struct MeshAndDropped {
    Mesh mesh;
    uint64_t dropped = 0; ///< triangles of zero area, which are removed
};

/// The mesh in world space. If the transform mirrors, the winding of triangles is reversed, so that
/// fronts stay fronts. Removes positions, normals and texture coordinates that no triangle uses.
/// Throws SceneError at `where` if a vertex is not finite after the transform, or if no triangle is
/// left.
MeshAndDropped buildMesh(const ObjectMesh& source, const AffineTransform& worldFromObject,
                         NormalMode mode, const std::string& where,
                         const OnProgress& onProgress = {});

/// The area of one side.
double triangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

} // namespace calotype
