#include "read/json/quadrics.h"

#include <cmath>
#include <string>

#include "math/rotation.h"
#include "read/json/transform.h"

namespace calotype {
namespace {

struct Placement {
    RigidTransform worldFromObject;
    double scale;
};

/// The shape's own origin at `origin` and +Y along `axis`, then its transform.
Placement place(const JsonObject& object, const std::string& originKey, const glm::dvec3& axis) {
    const SimilarityTransform outer = readSimilarity(object);
    const glm::dvec3 origin = object.vector(originKey, glm::dvec3(0.0));
    const Placement placement = {
        {outer.rigid.rotation * rotationTakingYTo(axis), outer.rigid.point(outer.scale * origin)},
        outer.scale};
    const glm::dvec3& t = placement.worldFromObject.translation;
    if (!std::isfinite(t.x + t.y + t.z)) {
        object.value().fail("the shape lies beyond the range of finite numbers");
    }
    return placement;
}

glm::dvec3 readAxis(const JsonObject& object) {
    object.exclude("transform", "axis");
    const auto axis = object.optional("axis");
    return axis ? axis->direction() : glm::dvec3(0.0, 1.0, 0.0);
}

/// A length after scaling; of either sign, but neither zero nor infinite.
double scaledLength(const JsonValue& value, double scale) {
    const double length = value.number() * scale;
    if (length == 0.0 || !std::isfinite(length)) {
        value.fail("must not be 0" +
                   std::string(std::isfinite(length) ? "" : " or beyond finite numbers"));
    }
    return length;
}

double scaledSize(const JsonValue& value, double scale) {
    value.positiveNumber();
    return scaledLength(value, scale);
}

} // namespace

Sphere readSphere(const JsonObject& object) {
    const Placement placement = place(object, "center", glm::dvec3(0.0, 1.0, 0.0));
    return {placement.worldFromObject, scaledSize(object.required("radius"), placement.scale)};
}

Cylinder readCylinder(const JsonObject& object) {
    const Placement placement = place(object, "center", readAxis(object));
    return {placement.worldFromObject, scaledSize(object.required("radius"), placement.scale),
            scaledSize(object.required("height"), placement.scale)};
}

Cone readCone(const JsonObject& object) {
    const Placement placement = place(object, "apex", readAxis(object));
    return {placement.worldFromObject, scaledLength(object.required("height"), placement.scale),
            object.required("slope").positiveNumber()};
}

Disk readDisk(const JsonObject& object) {
    const auto normal = object.optional("normal");
    const Placement placement =
        place(object, "center", normal ? normal->direction() : glm::dvec3(0.0, 1.0, 0.0));
    return {placement.worldFromObject, scaledSize(object.required("radius"), placement.scale)};
}

} // namespace calotype
