#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "reference/ray.h"
#include "scene/scene.h"

namespace calotype::reference {

/// A position relative to a pixel's top left corner, in pixels, distributed as the filter: inverts
/// the integral of each of its two factors.
glm::dvec2 samplePixel(FilmFilter filter, const glm::dvec2& u);

/// The ray through a position on a film of `imageSize` pixels, in pixels from its top left corner,
/// and the point of the lens that `uLens` chooses. Unit direction.
Ray cameraRay(const Camera& camera, const glm::uvec2& imageSize, const glm::dvec2& filmPosition,
              const glm::dvec2& uLens);

} // namespace calotype::reference
