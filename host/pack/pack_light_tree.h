#pragma once

#include "pack/gpu_scene.h"
#include "scene/scene.h"

namespace calotype {

/// Builds the light tree of a scene whose lights are packed, and lets it choose them: adds its
/// nodes, its depth and its feature, and gives each light its trail. With fewer than two lights of
/// primitives that emit, nothing changes: then the alias table chooses with the same probabilities.
/// The background keeps the probability that it has in the alias table.
void addLightTree(const Scene& scene, GpuScene& packed);

} // namespace calotype
