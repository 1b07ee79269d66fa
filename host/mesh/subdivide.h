#pragma once

#include <cstdint>

#include "mesh/object_mesh.h"
#include "scene/scene.h"

namespace calotype {

/// The number of triangles that `count` become, each turned into four `times` over. Beyond 2^64 it
/// is 2^64 - 1.
uint64_t subdividedCount(uint64_t count, uint32_t times);

/// Turns each triangle into four, `times` over, by the midpoints of its edges; what is
/// interpolated over a triangle stays as it was, but for normals, which are made one long again.
/// The triangles of one lie together and face the same way. Positions, normals and texture
/// coordinates of equal value become one, so that neighbours share their edges exactly, also where
/// texture seams part them or a file repeats a position. The caller has checked the count.
Mesh subdivide(const ObjectMesh& mesh, uint32_t times);

} // namespace calotype
