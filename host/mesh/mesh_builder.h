#pragma once

#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

#include "math/affine_transform.h"
#include "mesh/object_mesh.h"
#include "scene/scene.h"

namespace calotype {

/// Where a mesh's shading normals come from.
enum class NormalMode {
    Auto,   ///< as given, flat where there are none
    Smooth, ///< per position the mean over its triangles, weighted by area
    Flat,
};

struct MeshAndDropped {
    Mesh mesh;
    uint64_t dropped = 0; ///< triangles of zero area, which are left out
};

/// The mesh in world space. Where the transform mirrors, triangles are wound the other way, so that
/// fronts stay fronts. Positions, normals and texture coordinates that no triangle uses are left
/// out. Throws SceneError at `where` if a vertex leaves the range of finite numbers, or if no
/// triangle is left.
MeshAndDropped buildMesh(const ObjectMesh& source, const AffineTransform& worldFromObject,
                         NormalMode mode, const std::string& where);

/// Of one side.
double triangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

} // namespace calotype
