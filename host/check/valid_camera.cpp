#include "check/valid_camera.h"

#include <numbers>

#include "check/require.h"
#include "scene/place.h"

namespace calotype {

void requireValidCamera(const Scene& scene) {
    const Camera& camera = scene.camera;
    require(ranges::kAnyNumber, camera.position, placeOf(scene, "/camera/position"));
    requireOrthonormal({camera.right, camera.up, camera.forward}, placeOf(scene, "/camera"));
    if (camera.projection == Projection::Perspective) {
        require(ranges::kFieldOfView, camera.verticalFov * (180.0 / std::numbers::pi),
                placeOf(scene, "/camera/fov"));
    } else {
        require(ranges::kPositive, camera.viewHeight, placeOf(scene, "/camera/height"));
    }
    require(ranges::kLensRadius, camera.lensRadius, placeOf(scene, "/camera/lens_radius"));
    require(ranges::kPositive, camera.focusDistance, placeOf(scene, "/camera/focus_distance"));
    require(ranges::kPictureSide, scene.film.width, placeOf(scene, "/film/width"));
    require(ranges::kPictureSide, scene.film.height, placeOf(scene, "/film/height"));
    require(ranges::kSamplesPerPixel, scene.render.samplesPerPixel, placeOf(scene, "/render/spp"));
    require(ranges::kMaxBounces, scene.render.maxBounces, placeOf(scene, "/render/max_bounces"));
    require(ranges::kRadiance, scene.background, placeOf(scene, "/background"));
}

} // namespace calotype
