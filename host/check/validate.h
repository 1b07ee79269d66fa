#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Checks a scene, whatever file it was read from, or one made in memory. Throws SceneError, with a
/// place, for what cannot be rendered: numbers out of their ranges, and indices of what is not
/// there. Warns of what will not look as its author expects: materials that reflect too much, what
/// the device's single precision and fixed point do not hold well, and a black picture.
void validate(const Scene& scene, Warnings& warnings);

} // namespace calotype
