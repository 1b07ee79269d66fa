#pragma once

#include <cstdint>

#include "mesh/object_mesh.h"
#include "scene/scene.h"

namespace calotype {

/// The number of triangles after each of `count` triangles is split into four, `times` times. At
/// most 2^64 - 1, also for larger results.
uint64_t subdividedCount(uint64_t count, uint32_t times);

/// Splits each triangle into four at the midpoints of its edges, `times` times. Interpolated values
/// do not change, except that normals are normalised again. The triangles from one triangle are
/// consecutive and face the same way. Equal positions, normals and texture coordinates are merged,
/// so that neighbours share their edges exactly, even if a texture seam separates them or a file
/// repeats a position. The caller must check the count.
Mesh subdivide(const ObjectMesh& mesh, uint32_t times);

} // namespace calotype
