#include "check/small_shapes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/names.h"
#include "math/greatest.h"
#include "scene/place.h"
#include "scene/scene_bounds.h"

namespace calotype {
namespace {

constexpr double kRounding = 0x1p-23; ///< of a float, relative

/// Metres from the origin to the box's farthest side.
double farthest(const Bounds3d& bounds, const glm::dvec3& origin) {
    return greatest(glm::max(glm::abs(bounds.lower - origin), glm::abs(bounds.upper - origin)));
}

/// Metres: the extent that rounding must not blur; for a thin solid its width.
struct SizeOf {
    double operator()(const Sphere& sphere) const { return 2.0 * sphere.radius; }
    double operator()(const Cylinder& cylinder) const { return 2.0 * cylinder.radius; }
    double operator()(const Cone& cone) const { return 2.0 * std::abs(cone.height) * cone.slope; }
    double operator()(const Disk& disk) const { return 2.0 * disk.radius; }
    double operator()(const Mesh& mesh) const;

    const Bounds3d& bounds; ///< of the shape
    const glm::dvec3& origin;
};

double doubledArea(const glm::dvec3 (&corners)[3]) {
    return glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
}

/// The largest extent. For meshes of thin or scattered triangles: the side of a square whose area
/// changes by the same share through rounding. The errors of triangles are independent.
double SizeOf::operator()(const Mesh& mesh) const {
    double area = 0.0;
    double squaredChange = 0.0;
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        glm::dvec3 corners[3];
        glm::dvec3 rounded[3];
        for (size_t i = 0; i < 3; ++i) {
            corners[i] = mesh.positions[triangle.position[i]] - origin;
            rounded[i] = glm::dvec3(glm::vec3(corners[i]));
        }
        area += doubledArea(corners);
        squaredChange += std::pow(doubledArea(rounded) - doubledArea(corners), 2.0);
    }
    const double rounding = kRounding * farthest(bounds, origin);
    const double extent = greatest(bounds.extent());
    return squaredChange > 0.0 ? std::min(extent, rounding * area / std::sqrt(squaredChange))
                               : extent;
}

struct SmallShape {
    const Shape* shape = nullptr;
    double size = 0.0;      ///< metres
    double distance = 0.0;  ///< metres, along the axis on which it is largest
    double need = 0.0;      ///< required size over actual size
    bool isOfParts = false; ///< `size` is that of a mesh's triangles
};

SmallShape measure(const Shape& shape, const glm::dvec3& origin) {
    const Bounds3d bounds = shapeBounds(shape);
    const double size = std::visit(SizeOf{bounds, origin}, shape.geometry);
    const double distance = farthest(bounds, origin);
    return {&shape, size, distance, std::max(kSmallestShape, kSmallestShare * distance) / size,
            std::holds_alternative<Mesh>(shape.geometry) && size < greatest(bounds.extent())};
}

std::string consequence(const SmallShape& shape) {
    if (shape.size < kSmallestShape)
        return "; below 1e-11 m single precision may let rays through: scale the scene up";
    return ", " + twoDigits(shape.distance) +
           " m from the camera or the scene's near side, where single precision resolves positions "
           "to " +
           twoDigits(kRounding * shape.distance) +
           " m, so that its light and shadow are off by half a percent or more; bring the camera "
           "closer";
}

} // namespace

void warnOfSmallShapes(const Scene& scene, Warnings& warnings) {
    const glm::dvec3 origin = cameraWithinBounds(scene);
    SmallShape smallest;
    size_t count = 0;
    for (const Shape& shape : scene.shapes) {
        const SmallShape measured = measure(shape, origin);
        if (measured.need > 1.0) {
            ++count;
            smallest = measured.need > smallest.need ? measured : smallest;
        }
    }
    if (count > 0) {
        warnings.add(
            placeOf(scene, *smallest.shape),
            (smallest.isOfParts ? "has triangles only " : "is only ") + twoDigits(smallest.size) +
                " m wide" + consequence(smallest) +
                (count > 1 ? " (" + std::to_string(count - 1) + " more are as small)" : ""));
    }
}

} // namespace calotype
