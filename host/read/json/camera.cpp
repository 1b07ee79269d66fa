#include "read/json/camera.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "math/affine_transform.h"
#include "read/json/transform.h"

namespace calotype {
namespace {

/// In the order of Projection.
const std::array<std::string, 2> kProjections = {"perspective", "orthographic"};
constexpr double kDefaultFov = 40.0;
/// Below this sine of the angle between them, `up` and the view count as parallel.
constexpr double kParallelSine = 1e-6;
/// A camera's matrix may differ from a rigid one by this much in scale.
constexpr double kRigidTolerance = 1e-4;

void placeByMatrix(Camera& camera, const JsonValue& matrix) {
    const AffineTransform transform = readMatrix(matrix);
    const auto similarity = asSimilarity(transform);
    if (!similarity || std::abs(similarity->scale - 1.0) > kRigidTolerance ||
        isMirroring(transform.linear)) {
        matrix.fail("a camera's matrix must be a rotation and a translation; this one scales, "
                    "shears or mirrors");
    }
    const RigidTransform& rigid = similarity->rigid;
    camera.position = rigid.translation;
    camera.right = rigid.rotation[0];
    camera.up = rigid.rotation[1];
    camera.forward = -rigid.rotation[2];
}

void placeByTarget(Camera& camera, const JsonObject& object) {
    camera.position = object.vector("position", glm::dvec3(0.0));
    if (const auto target = object.optional("target")) {
        const glm::dvec3 view = target->vector() - camera.position;
        const double distance = glm::length(view);
        if (distance == 0.0)
            target->fail("is the camera's position too, so that it looks nowhere");
        camera.forward = view / distance;
        if (!std::isfinite(distance))
            target->fail("is too far from the camera's position to compute the direction");
    }
    const auto upValue = object.optional("up");
    const glm::dvec3 up = upValue ? upValue->direction() : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 right = glm::cross(camera.forward, up);
    if (glm::length(right) < kParallelSine)
        object.value().child("up").fail("is parallel to the direction of view; choose another");
    camera.right = glm::normalize(right);
    camera.up = glm::cross(camera.right, camera.forward);
}

bool isOrthographic(const JsonObject& object) {
    return object.choice("type", kProjections, 0) == static_cast<size_t>(Projection::Orthographic);
}

/// An orthographic camera has a "height", a perspective camera a "fov".
void checkView(const JsonObject& object) {
    if (isOrthographic(object)) {
        object.required("height");
        if (const auto fov = object.optional("fov")) {
            fov->fail("belongs to a perspective camera; this one is orthographic and has "
                      "\"height\"");
        }
    } else if (const auto height = object.optional("height")) {
        height->fail("belongs to an orthographic camera; this one is in perspective and has "
                     "\"fov\"");
    }
}

constexpr const char* kViewSchema = R"({
    "if": {"required": ["type"], "properties": {"type": {"const": "orthographic"}}},
    "then": {"required": ["height"], "not": {"required": ["fov"]}},
    "else": {"not": {"required": ["height"]}}})";

/// A lens needs a focus distance.
void checkFocus(const JsonObject& object) {
    if (object.number("lens_radius", 0.0) > 0.0 && !object.has("focus_distance") &&
        !object.has("target")) {
        object.value().fail("lacks \"focus_distance\", which a camera with a \"lens_radius\" and "
                            "without a \"target\" needs");
    }
}

constexpr const char* kFocusSchema = R"({
    "if": {"required": ["lens_radius"], "properties": {"lens_radius": {"exclusiveMinimum": 0}}},
    "then": {"anyOf": [{"required": ["focus_distance"]}, {"required": ["target"]}]}})";

const JsonObjectType& cameraObject() {
    static const JsonObjectType type = {
        {
            JsonKey("type", choiceType(kProjections),
                    "orthographic sees the same height at every distance.")
                .orElseJson("\"perspective\""),
            JsonKey("position", vectorType(), "Where the camera is.")
                .in("metres")
                .orElseJson("[0, 0, 0]"),
            JsonKey("target", vectorType(), "A point to look at; by default position + (0, 0, -1).")
                .in("metres"),
            JsonKey("up", directionType(),
                    "A direction that is up in the picture; not parallel to the view.")
                .orElseJson("[0, 1, 0]"),
            JsonKey("matrix", matrixType(),
                    "worldFromCamera, a rotation and a translation, in place of position, target "
                    "and up. The camera looks along its -Z."),
            JsonKey("fov", numberType(ranges::kFieldOfView),
                    "Perspective: the vertical field of view, whatever the aspect ratio.")
                .in("degrees")
                .orElse(kDefaultFov),
            JsonKey("height", numberType(ranges::kPositive),
                    "Orthographic: the height of the view.")
                .in("metres"),
            JsonKey("lens_radius", numberType(ranges::kLensRadius),
                    "The radius of a thin lens; 0 is a pinhole.")
                .in("metres")
                .orElse(0.0),
            JsonKey("focus_distance", numberType(ranges::kPositive),
                    "Along the viewing axis to the plane in focus; by default that of the target. "
                    "A pinhole ignores it.")
                .in("metres"),
        },
        {exclude("matrix", "position"),
         exclude("matrix", "target"),
         exclude("matrix", "up"),
         {checkView, kViewSchema},
         {checkFocus, kFocusSchema}},
        "Placed by position, target and up, or by a matrix. Without a target it looks along -Z."};
    return type;
}

/// Reads the opening of the view: an angle for perspective, else a height.
void readView(const JsonObject& object, Camera& camera) {
    if (isOrthographic(object)) {
        camera.projection = Projection::Orthographic;
        camera.viewHeight = object.required("height").number();
    } else {
        camera.verticalFov = object.number("fov", kDefaultFov) * (std::numbers::pi / 180.0);
    }
}

/// Reads a thin lens; without a focus distance it focuses on the target.
void readLens(const JsonObject& object, Camera& camera) {
    camera.lensRadius = object.number("lens_radius", camera.lensRadius);
    if (const auto distance = object.optional("focus_distance"))
        camera.focusDistance = distance->number();
    else if (const auto target = object.optional("target"))
        camera.focusDistance = glm::dot(camera.forward, target->vector() - camera.position);
}

} // namespace

JsonType cameraType() { return cameraObject().asType("camera"); }

Camera readCamera(const JsonValue& value) {
    const JsonObject object(value, cameraObject());
    Camera camera;
    if (const auto matrix = object.optional("matrix"))
        placeByMatrix(camera, *matrix);
    else
        placeByTarget(camera, object);
    readView(object, camera);
    readLens(object, camera);
    return camera;
}

} // namespace calotype
