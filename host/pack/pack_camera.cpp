#include "pack/pack_camera.h"

#include <cmath>

#include "accel/primitive.h"

namespace calotype {

gpu::Camera packCamera(const Camera& camera, FilmFilter filter, const glm::dvec3& origin,
                       double aspectRatio) {
    const bool orthographic = camera.projection == Projection::Orthographic;
    const double halfHeight =
        orthographic ? 0.5 * camera.viewHeight : std::tan(0.5 * camera.verticalFov);
    gpu::Camera packed{};
    packed.position = packPosition(camera.position, origin);
    packed.focusDistance = static_cast<float>(camera.focusDistance);
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
