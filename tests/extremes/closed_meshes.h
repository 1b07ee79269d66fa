#pragma once

#include <functional>
#include <vector>

#include "scene/scene.h"

namespace calotype::test {

/// Every position replaced by what `place` makes of it. Corners that were equal stay equal.
Mesh withPositions(Mesh mesh, const std::function<glm::dvec3(const glm::dvec3&)>& place);

/// Turned so that no axis, edge or side of it is parallel to one of the world's.
Mesh turned(Mesh mesh);

Mesh stretched(Mesh mesh, const glm::dvec3& factors);

Mesh moved(Mesh mesh, const glm::dvec3& offset);

/// A ball about the origin whose radius goes up and down by half, seen as a whole from there.
Mesh displacedBall(uint32_t level);

/// The surface of the cube from -1 to 1, each side cut into rectangles at the same places along
/// both its axes: from -1 to 1, ascending. Closed, corners bit-identical.
Mesh boxWithCuts(const std::vector<double>& cuts);

/// Cuts such that slivers `width` wide lie along the edges of a box, in a comb and alone.
std::vector<double> sliverCuts(double width);

} // namespace calotype::test
