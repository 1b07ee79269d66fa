#pragma once

#include "scene/scene.h"
#include "shared/scene_structs.h"

namespace calotype {

/// The camera relative to `origin`; `aspectRatio` is the picture's width over its height. Throws
/// SceneError if single precision cannot represent its rays.
shared::Camera packCamera(const Camera& camera, FilmFilter filter, const glm::dvec3& origin,
                          double aspectRatio);

} // namespace calotype
