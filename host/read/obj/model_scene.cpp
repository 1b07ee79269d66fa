#include "read/obj/model_scene.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/names.h"
#include "check/excess_energy.h"
#include "check/radiance_range.h"
#include "math/bounds.h"
#include "math/rotation.h"
#include "read/frame_camera.h"
#include "read/framed_points.h"
#include "read/obj/obj_materials.h"
#include "read/obj/obj_mesh.h"
#include "read/read_context.h"

namespace calotype {
namespace {

constexpr double kDegrees = std::numbers::pi / 180.0;

constexpr double kFieldOfView = 30.0 * kDegrees;
constexpr double kCameraAzimuth = 35.0 * kDegrees;
constexpr double kCameraElevation = 20.0 * kDegrees;
constexpr double kShareOfPicture = 0.9;
/// Below this sine of the angle between them, `up` and the view count as parallel.
constexpr double kParallelSine = 1e-6;

constexpr double kFloorReflectance = 0.5;
constexpr double kBackground = 0.3;
constexpr uint32_t kMaxBounces = 8; ///< enough to go through glass and out again

/// In units of the model's radius.
constexpr double kLightDistance = 5.0;
/// Distance from the floor to a model's lowest point, so that the two are not in one plane.
constexpr double kFloorGap = 1e-3;
/// In units of the camera's distance. The picture's upper edge looks 5 degrees down, so that even a
/// very wide picture shows no floor beyond this.
constexpr double kFloorSize = 15.0;

/// Outside these radii, in metres, squared lengths exceed the range of the device's floats.
constexpr double kSmallestRadius = 1e-12;
constexpr double kLargestRadius = 1e12;

/// A square light that faces the model, at angles around it (azimuth counter-clockwise from +Z).
struct LightPlan {
    const char* name;
    double azimuth;
    double elevation;
    double side;     ///< in units of the model's radius
    double radiance; ///< W/(m^2 sr)
};
constexpr LightPlan kLights[] = {
    {"key light", kCameraAzimuth - 55.0 * kDegrees, 55.0 * kDegrees, 3.0, 6.0},
    {"fill light", kCameraAzimuth + 65.0 * kDegrees, 30.0 * kDegrees, 2.5, 2.0},
};

glm::dvec3 directionAt(double azimuth, double elevation) {
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
            std::cos(azimuth) * std::cos(elevation)};
}

/// The box's centre and half its diagonal, and the floor's height.
struct ModelExtent {
    glm::dvec3 center;
    double radius;
    double floor; ///< y of its lower side
};

ModelExtent extentOf(const std::vector<glm::dvec3>& points, const std::string& path) {
    Bounds3d bounds;
    for (const glm::dvec3& point : points)
        bounds.extend(point);
    const ModelExtent extent = {0.5 * bounds.lower + 0.5 * bounds.upper,
                                0.5 * glm::length(bounds.extent()), bounds.lower.y};
    if (!(extent.radius >= kSmallestRadius && extent.radius <= kLargestRadius)) {
        throw SceneError(path, "the model is too small or too large to be framed; place it in a "
                               "scene file with a \"transform\"");
    }
    return extent;
}

/// Films of different views do not belong together. Without options the hash is that of the files.
void addToHash(const ViewOptions& view, ContentHash& hash) {
    const auto add = [&](const char* name, std::span<const double> numbers) {
        hash.add(name);
        for (const double number : numbers)
            hash.add({reinterpret_cast<const char*>(&number), sizeof number});
    };
    const auto addPoint = [&](const char* name, const std::optional<glm::dvec3>& point) {
        if (point)
            add(name, std::array{point->x, point->y, point->z});
    };
    addPoint("from", view.from);
    addPoint("look-at", view.lookAt);
    addPoint("up", view.up);
    if (view.fov)
        add("fov", std::array{*view.fov});
}

Shape readModel(const std::string& path, ReadContext& context) {
    ObjCache cache;
    const std::shared_ptr<const ObjFile> obj = readObj(path, path, cache, context);
    ObjMeshInput input{.path = path,
                       .where = path,
                       .materials =
                           materialsFromMtl(*obj, path, allMaterials(*obj), cache, context),
                       .displacements = {},
                       .worldFromObject = {}};
    const BegunObjMesh begun = beginObjMesh(obj, std::move(input), context);
    return {.geometry = finishObjMesh(begun, context), .place = path, .file = path};
}

/// Turns the camera to look along `view`. Throws SceneError, at the option that was given, if that
/// is no direction, or along `up`.
void turnCamera(Camera& camera, const glm::dvec3& view, const ViewOptions& options) {
    const double distance = glm::length(view);
    if (!(distance > 0.0 && std::isfinite(distance)))
        throw SceneError(options.lookAt ? "--look-at" : "--from",
                         "the camera and the point that it looks at must be different, and not "
                         "farther apart than finite numbers reach");
    camera.forward = view / distance;
    const glm::dvec3 up = options.up.value_or(glm::dvec3(0.0, 1.0, 0.0));
    const double upLength = glm::length(up);
    if (!(upLength > 0.0 && std::isfinite(upLength)))
        throw SceneError("--up", "must be a direction, so not zero");
    const glm::dvec3 right = glm::cross(camera.forward, up / upLength);
    if (!(glm::length(right) > kParallelSine))
        throw SceneError(options.up ? "--up" : "--from",
                         "the direction of view is parallel to the one that is up in the picture; "
                         "choose another with --up");
    camera.right = glm::normalize(right);
    camera.up = glm::cross(camera.right, camera.forward);
}

/// Shows all points, or what the options say.
Camera placeCamera(const std::vector<glm::dvec3>& points, const ModelExtent& extent,
                   const ViewOptions& view) {
    Camera camera;
    camera.verticalFov = view.fov ? *view.fov * kDegrees : kFieldOfView;
    const glm::dvec3 target = view.lookAt.value_or(extent.center);
    if (view.from) {
        camera.position = *view.from;
        camera.focusDistance = glm::length(target - *view.from);
        turnCamera(camera, target - *view.from, view);
        return camera;
    }
    turnCamera(camera, -directionAt(kCameraAzimuth, kCameraElevation), view);
    frameCamera(camera, points, kShareOfPicture, extent.radius, extent.center);
    if (view.lookAt)
        camera.position = target - camera.focusDistance * camera.forward;
    return camera;
}

/// Warns if a part is many times larger than all others.
std::vector<glm::dvec3> pointsToShow(const Mesh& mesh, const std::string& path,
                                     ReadContext& context) {
    FramedPoints framed = framedPoints(mesh);
    if (framed.ratio > 1.0)
        context.warn(path, "a part of the model is " + twoDigits(framed.ratio) +
                               " times larger than all others; the picture shows " +
                               (framed.leavesOutLargest ? "the others" : "all of it") +
                               "; --from and --look-at choose another view");
    return std::move(framed.points);
}

void addFloor(const ModelExtent& extent, const Camera& camera, ReadContext& context) {
    Material grey;
    grey.name = "floor";
    grey.color = glm::dvec3(kFloorReflectance);
    const glm::dvec3 center(extent.center.x, extent.floor - kFloorGap * extent.radius,
                            extent.center.z);
    Disk disk;
    disk.worldFromObject.translation = center;
    disk.radius = kFloorSize * glm::length(camera.position - center);
    context.scene.shapes.push_back(
        {disk, context.addMaterial(grey), "floor", /*file=*/"", /*name=*/"floor"});
}

void addLight(const LightPlan& plan, const ModelExtent& extent, ReadContext& context) {
    Material material;
    material.name = plan.name;
    material.emission = glm::dvec3(plan.radiance);
    material.emitsFromFrontOnly = true;
    const uint32_t index = context.addMaterial(material);

    const glm::dvec3 outward = directionAt(plan.azimuth, plan.elevation);
    const glm::dvec3 center = extent.center + kLightDistance * extent.radius * outward;
    const double half = 0.5 * plan.side * extent.radius;
    const glm::dmat3 frame = rotationTakingYTo(-outward);
    const glm::dvec3 x = half * frame[0];
    const glm::dvec3 z = half * frame[2];
    constexpr uint32_t kNone = Mesh::kNoNormal;
    Mesh quad;
    quad.positions = {center - x + z, center + x + z, center + x - z, center - x - z};
    quad.triangles = {{{0, 1, 2}, {kNone, kNone, kNone}, index},
                      {{0, 2, 3}, {kNone, kNone, kNone}, index}};
    context.scene.shapes.push_back({quad, index, plan.name, /*file=*/"", plan.name});
}

} // namespace

SceneAndNotes readModelScene(const std::string& path, const LoadOptions& options) {
    if (!options.overrides.empty()) {
        throw SceneError("--set " + options.overrides.front().pointer,
                         inQuotes(path) +
                             " is a model, not a scene file, so there are no values to "
                             "set; name the model in a scene as a \"mesh\"");
    }
    ReadContext context(options, path);
    Scene& scene = context.scene;
    scene.render.maxBounces = kMaxBounces;
    scene.background = glm::dvec3(kBackground);
    scene.shapes.push_back(readModel(path, context));
    scene.shapes.back().name = std::filesystem::path(path).filename().string();

    const Mesh& mesh = std::get<Mesh>(scene.shapes.front().geometry);
    const std::vector<glm::dvec3> points = pointsToShow(mesh, path, context);
    const ModelExtent extent = extentOf(points, path);
    scene.camera = placeCamera(points, extent, options.view);
    addToHash(options.view, context.hash);
    addFloor(extent, scene.camera, context);
    for (const LightPlan& plan : kLights)
        addLight(plan, extent, context);
    return std::move(context).finish();
}

} // namespace calotype
