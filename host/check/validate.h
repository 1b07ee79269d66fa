#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Checks a scene that was read from any file or made in memory. Throws SceneError, with a place,
/// for what cannot be rendered: numbers out of their ranges, and invalid indices. Warns of results
/// that its author may not expect: materials that reflect too much, features that exceed the
/// device's single precision or the film's fixed point, and a black picture.
void validate(const Scene& scene, Warnings& warnings);

} // namespace calotype
