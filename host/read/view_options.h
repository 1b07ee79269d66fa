#pragma once

#include <optional>

#include <glm/vec3.hpp>

namespace calotype {

/// Another view than the scene's own, or than the one that a bare model gets. Metres.
struct ViewOptions {
    std::optional<glm::dvec3> from = {};   ///< where the camera is
    std::optional<glm::dvec3> lookAt = {}; ///< a point that it looks at
    std::optional<glm::dvec3> up = {};     ///< a direction that is up in the picture
    std::optional<double> fov = {};        ///< vertical field of view in degrees, in (0, 180)

    bool isEmpty() const { return !from && !lookAt && !up && !fov; }
};

} // namespace calotype
