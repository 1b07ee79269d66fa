#include "read/frame_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace calotype {
namespace {

/// One of the picture's two axes. A point at `along` on the axis, `depth` in front of the focus, is
/// visible to a camera at `offset`, `distance` behind the focus, if |along - offset| <= tangent *
/// (depth + distance). The largest sums give lower bounds for offset and distance.
class Extent {
public:
    explicit Extent(double tangent) : tangent_(tangent) {}

    void add(double along, double depth) {
        upper_ = std::max(upper_, along - tangent_ * depth);
        lower_ = std::max(lower_, -along - tangent_ * depth);
    }

    double offset() const { return 0.5 * (upper_ - lower_); }
    double distance() const { return 0.5 * (upper_ + lower_) / tangent_; }

private:
    double tangent_;
    double upper_ = -std::numeric_limits<double>::infinity();
    double lower_ = -std::numeric_limits<double>::infinity();
};

} // namespace

void frameCamera(Camera& camera, std::span<const glm::dvec3> points, double share, double clearance,
                 const glm::dvec3& focus) {
    const double tangent = share * std::tan(0.5 * camera.verticalFov);
    Extent horizontal(tangent);
    Extent vertical(tangent);
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& point : points) {
        const glm::dvec3 p = point - focus;
        const double depth = glm::dot(p, camera.forward);
        horizontal.add(glm::dot(p, camera.right), depth);
        vertical.add(glm::dot(p, camera.up), depth);
        nearest = std::min(nearest, depth);
    }
    const double distance =
        std::max({horizontal.distance(), vertical.distance(), clearance - nearest});
    camera.position = focus + horizontal.offset() * camera.right + vertical.offset() * camera.up -
                      distance * camera.forward;
    camera.focusDistance = distance;
}

} // namespace calotype
