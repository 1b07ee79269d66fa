#include "check/camera_precision.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/place.h"
#include "scene/scene_bounds.h"

namespace calotype {
namespace {

/// Radians between neighbouring pixels. The device's rays deviate by 7e-8 rad (root mean square),
/// and by 2.2e-7 at most (measured; tests/extremes): a tenth and a quarter of such a pixel.
constexpr double kFinestPixel = 1e-6;

/// Lens radius over focus distance. In the plane of focus, the error of a lens's rays grows with
/// the square of this ratio: at 100 it is 2.2e-3 of the focus distance.
constexpr double kWidestLens = 100.0;

/// In such a view, small angles keep all their digits.
bool isAlongAxis(const glm::dvec3& direction) {
    const glm::dvec3 sizes = glm::abs(direction);
    return std::max({sizes.x, sizes.y, sizes.z}) == sizes.x + sizes.y + sizes.z;
}

/// Metres from the camera to the box around the scene; 0 inside.
double distanceToScene(const Scene& scene) {
    return glm::distance(scene.camera.position, cameraWithinBounds(scene));
}

} // namespace

void warnOfCameraPrecision(const Scene& scene, Warnings& warnings) {
    const Camera& camera = scene.camera;
    if (isAlongAxis(camera.forward))
        return;
    const double rows = scene.film.height;
    if (camera.projection == Projection::Perspective) {
        if (2.0 * std::tan(0.5 * camera.verticalFov) < kFinestPixel * rows) {
            warnings.add(placeOf(scene, "/camera/fov"),
                         "is so narrow that rays of neighbouring pixels are less than 1e-6 "
                         "radians apart, which single precision hardly resolves; look along an "
                         "axis of the world, or come closer and widen it");
        }
    } else if (camera.viewHeight < kFinestPixel * rows * distanceToScene(scene)) {
        warnings.add(placeOf(scene, "/camera/height"),
                     "makes pixels smaller than 1e-6 of the camera's distance from the scene, "
                     "which single precision hardly resolves; look along an axis of the world, or "
                     "come closer");
    }
    if (camera.lensRadius > kWidestLens * camera.focusDistance) {
        warnings.add(placeOf(scene, "/camera/lens_radius"),
                     "is more than 100 times the focus_distance, so that single precision blurs "
                     "what is in focus; lower it, or look along an axis of the world");
    }
}

} // namespace calotype
