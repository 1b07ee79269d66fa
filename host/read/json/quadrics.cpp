#include "read/json/quadrics.h"

#include <cmath>
#include <string>
#include <vector>

#include "math/rotation.h"
#include "read/json/transform.h"

namespace calotype {
namespace {

struct Placement {
    RigidTransform worldFromObject;
    double scale;
};

/// The shape's own origin at `origin` and +Y along `axis`, followed by its transform.
Placement place(const JsonObject& object, const std::string& originKey, const glm::dvec3& axis) {
    const SimilarityTransform outer = readSimilarity(object);
    const glm::dvec3 origin = object.vector(originKey, glm::dvec3(0.0));
    const Placement placement = {
        {outer.rigid.rotation * rotationTakingYTo(axis), outer.rigid.point(outer.scale * origin)},
        outer.scale};
    const glm::dvec3& t = placement.worldFromObject.translation;
    if (!std::isfinite(t.x + t.y + t.z))
        object.value().fail("the shape lies beyond the range of finite numbers");
    return placement;
}

glm::dvec3 readAxis(const JsonObject& object) {
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

JsonKey originKey(const char* name, const char* description) {
    return JsonKey(name, vectorType(), description).in("metres").orElseJson("[0, 0, 0]");
}

JsonKey directionKey(const char* name, const char* description) {
    return JsonKey(name, directionType(), description).orElseJson("[0, 1, 0]");
}

JsonKey lengthKey(const char* name, const char* description) {
    return JsonKey(name, numberType(ranges::kPositive), description).in("metres").required();
}

JsonKey axisKey() { return directionKey("axis", "The shape's axis; not together with transform."); }

} // namespace

std::vector<JsonKey> sphereKeys() {
    return {originKey("center", "The centre."), lengthKey("radius", "The radius.")};
}

std::vector<JsonKey> cylinderKeys() {
    return {originKey("center", "The point half way between the caps."),
            lengthKey("radius", "The radius."), lengthKey("height", "The height from cap to cap."),
            axisKey()};
}

std::vector<JsonKey> coneKeys() {
    return {originKey("apex", "The tip."),
            JsonKey("height", nonZeroNumberType(),
                    "The height of the base above the apex; negative for a base below it.")
                .in("metres")
                .required(),
            JsonKey("slope", numberType(ranges::kPositive),
                    "The radius over the distance from the apex along the axis: the base has the "
                    "radius slope * |height|. docs/scenes.md has a drawing.")
                .required(),
            axisKey()};
}

std::vector<JsonKey> diskKeys() {
    return {originKey("center", "The centre."),
            directionKey("normal", "The direction that the front faces."),
            lengthKey("radius", "The radius.")};
}

JsonRule axisRule() { return exclude("transform", "axis"); }

Sphere readSphere(const JsonObject& object) {
    const Placement placement = place(object, "center", glm::dvec3(0.0, 1.0, 0.0));
    return {placement.worldFromObject, scaledLength(object.required("radius"), placement.scale)};
}

Cylinder readCylinder(const JsonObject& object) {
    const Placement placement = place(object, "center", readAxis(object));
    return {placement.worldFromObject, scaledLength(object.required("radius"), placement.scale),
            scaledLength(object.required("height"), placement.scale)};
}

Cone readCone(const JsonObject& object) {
    const Placement placement = place(object, "apex", readAxis(object));
    return {placement.worldFromObject, scaledLength(object.required("height"), placement.scale),
            object.required("slope").number()};
}

Disk readDisk(const JsonObject& object) {
    const auto normal = object.optional("normal");
    const Placement placement =
        place(object, "center", normal ? normal->direction() : glm::dvec3(0.0, 1.0, 0.0));
    return {placement.worldFromObject, scaledLength(object.required("radius"), placement.scale)};
}

} // namespace calotype
