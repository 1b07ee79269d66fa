#include "pack/pack_camera.h"

#include <algorithm>
#include <cmath>

#include "accel/primitive.h"
#include "base/error.h"

namespace calotype {
namespace {

/// Metres. Like the limit for coordinates of shapes: the kernels form cubes of lengths.
constexpr double kLargestLength = 1e12;
/// Tangent of the angle between a ray and the view direction: its square must stay within float.
constexpr double kLargestSlope = 1e18;
/// Metres; within float, also after multiplication with a lens of up to kLargestLength.
constexpr double kFarthestFocus = 1e30;

/// `halfHeight` is in metres or, in perspective, the tangent of half the field of view.
void requirePackable(const Camera& camera, double halfHeight, double aspectRatio) {
    const double halfSize = halfHeight * std::max(1.0, aspectRatio);
    const bool orthographic = camera.projection == Projection::Orthographic;
    if ((orthographic && halfSize > kLargestLength) || camera.lensRadius > kLargestLength)
        throw SceneError("the camera", "has a view or a lens of more than 1e12 metres; scale the "
                                       "scene down");
    const double slope = camera.lensRadius > 0.0 ? camera.lensRadius / camera.focusDistance : 0.0;
    if ((!orthographic && halfSize > kLargestSlope) || !(slope <= kLargestSlope))
        throw SceneError("the camera", "has a lens or a view so wide that its rays lie across the "
                                       "direction of view; lower lens_radius or fov");
}

} // namespace

shared::Camera packCamera(const Camera& camera, FilmFilter filter, const glm::dvec3& origin,
                          double aspectRatio) {
    const bool orthographic = camera.projection == Projection::Orthographic;
    const double halfHeight =
        orthographic ? 0.5 * camera.viewHeight : std::tan(0.5 * camera.verticalFov);
    requirePackable(camera, halfHeight, aspectRatio);
    shared::Camera packed{};
    packed.position = packPosition(camera.position, origin);
    packed.focusDistance = static_cast<float>(std::min(camera.focusDistance, kFarthestFocus));
    packed.right = glm::vec3(camera.right * (halfHeight * aspectRatio));
    packed.isOrthographic = orthographic;
    packed.up = glm::vec3(camera.up * halfHeight);
    packed.filterIsBox = filter == FilmFilter::Box;
    packed.forward = glm::vec3(camera.forward);
    packed.lensRight = glm::vec3(camera.right * camera.lensRadius);
    packed.lensUp = glm::vec3(camera.up * camera.lensRadius);
    return packed;
}

} // namespace calotype
