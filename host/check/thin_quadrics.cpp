#include "check/thin_quadrics.h"

#include <algorithm>
#include <string>

#include "base/names.h"
#include "scene/place.h"

namespace calotype {
namespace {

/// Height over radius, or the slope, or the inverse if larger; 1 for other shapes.
double proportionOf(const Shape& shape) {
    if (const auto* cylinder = std::get_if<Cylinder>(&shape.geometry))
        return cylinder->height / cylinder->radius;
    const auto* cone = std::get_if<Cone>(&shape.geometry);
    return cone ? cone->slope : 1.0;
}

} // namespace

void warnOfThinQuadrics(const Scene& scene, Warnings& warnings) {
    constexpr double kInverseRounding = 1e-9; // 1e-4 has no exact inverse
    const Shape* thinnest = nullptr;
    double greatest = 0.0;
    size_t count = 0;
    for (const Shape& shape : scene.shapes) {
        const double proportion = proportionOf(shape);
        const double excess = std::max(proportion, 1.0 / proportion);
        if (excess <= kThinnestProportion * (1.0 + kInverseRounding))
            continue;
        ++count;
        if (excess > greatest) {
            greatest = excess;
            thinnest = &shape;
        }
    }
    if (thinnest != nullptr) {
        const bool isCone = std::holds_alternative<Cone>(thinnest->geometry);
        warnings.add(placeOf(scene, *thinnest),
                     std::string("the ") + (isCone ? "cone" : "cylinder") + " is " +
                         twoDigits(greatest) + " times larger one way than the other" +
                         (count > 1 ? ", the most of " + std::to_string(count) + " so thin" : "") +
                         "; beyond 1e4 single precision lets light through its edges");
    }
}

} // namespace calotype
