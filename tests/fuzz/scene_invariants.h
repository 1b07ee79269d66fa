#pragma once

#include "scene/scene.h"

namespace calotype::fuzz {

/// Aborts unless `scene` is as scene/scene.h promises: every number finite, sizes positive,
/// directions of unit length, indices within their arrays.
void checkScene(const Scene& scene);

} // namespace calotype::fuzz
