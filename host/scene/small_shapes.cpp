#include "scene/small_shapes.h"

#include <algorithm>
#include <string>

#include <glm/common.hpp>

#include "scene/names.h"
#include "scene/scene_bounds.h"

namespace calotype {
namespace {

constexpr double kRounding = 0x1p-23; ///< of a float, relative

double greatest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

/// Metres that have to be told apart: the smallest measure of a solid, the largest of a mesh, whose
/// parts may be flat.
struct SizeOf {
    double operator()(const Sphere& sphere) const { return 2.0 * sphere.radius; }
    double operator()(const Cylinder& cylinder) const {
        return std::min(2.0 * cylinder.radius, cylinder.height);
    }
    double operator()(const Cone& cone) const {
        return std::abs(cone.height) * std::min(2.0 * cone.slope, 1.0);
    }
    double operator()(const Disk& disk) const { return 2.0 * disk.radius; }
    double operator()(const Mesh&) const { return greatest(bounds.extent()); }

    const Bounds3d& bounds; ///< of the shape
};

struct SmallShape {
    const Shape* shape = nullptr;
    double size = 0.0;     ///< metres
    double distance = 0.0; ///< metres, along the axis on which it is largest
    double need = 0.0;     ///< the size it ought to have over the one it has
};

SmallShape measure(const Shape& shape, const glm::dvec3& origin) {
    const Bounds3d bounds = shapeBounds(shape);
    const double size = std::visit(SizeOf{bounds}, shape.geometry);
    const double distance =
        greatest(glm::max(glm::abs(bounds.lower - origin), glm::abs(bounds.upper - origin)));
    return {&shape, size, distance, std::max(kSmallestShape, kSmallestShare * distance) / size};
}

std::string consequence(const SmallShape& shape) {
    if (shape.size < kSmallestShape) {
        return "; below 1e-11 m single precision lets rays through: scale the scene up";
    }
    return ", " + twoDigits(shape.distance) +
           " m from the camera or the scene's near side, where single precision knows places to " +
           twoDigits(kRounding * shape.distance) +
           " m, so that its light and shadow are off by half a percent or more; bring the camera "
           "closer";
}

} // namespace

void warnOfSmallShapes(LoadContext& context) {
    const glm::dvec3 origin = cameraWithinBounds(context.scene);
    SmallShape smallest;
    size_t count = 0;
    for (const Shape& shape : context.scene.shapes) {
        const SmallShape measured = measure(shape, origin);
        if (measured.need > 1.0) {
            ++count;
            smallest = measured.need > smallest.need ? measured : smallest;
        }
    }
    if (count > 0) {
        context.warn(
            smallest.shape->place,
            "is only " + twoDigits(smallest.size) + " m large" + consequence(smallest) +
                (count > 1 ? " (" + std::to_string(count - 1) + " more are as small)" : ""));
    }
}

} // namespace calotype
