#include "scene/read_settings.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "math/affine_transform.h"
#include "scene/read_transform.h"

namespace calotype {
namespace {

constexpr uint32_t kLargestSide = 65535;
constexpr uint32_t kLargestSeed = std::numeric_limits<uint32_t>::max();
constexpr double kDefaultFov = 40.0;
/// Sine of the angle between `up` and the view below which they count as parallel.
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
        if (distance == 0.0) {
            target->fail("is the camera's position too, so that it looks nowhere");
        }
        camera.forward = view / distance;
        if (!std::isfinite(distance)) {
            target->fail("is too far from the camera's position to tell the direction");
        }
    }
    const auto upValue = object.optional("up");
    const glm::dvec3 up = upValue ? upValue->direction() : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 right = glm::cross(camera.forward, up);
    if (glm::length(right) < kParallelSine) {
        object.value().child("up").fail("is parallel to the direction of view; choose another");
    }
    camera.right = glm::normalize(right);
    camera.up = glm::cross(camera.right, camera.forward);
}

} // namespace

Camera readCamera(const JsonValue& value) {
    const JsonObject object(value, {"type", "position", "target", "up", "matrix", "fov", "height",
                                    "lens_radius", "focus_distance"});
    if (const auto type = object.optional("type")) {
        static const std::array<std::string, 2> kTypes = {"perspective", "orthographic"};
        if (type->choice(kTypes) == 1) {
            failUnsupported(*type, "the type \"orthographic\"");
        }
    }
    if (const auto height = object.optional("height")) {
        height->fail("belongs to an orthographic camera; this one is in perspective and has "
                     "\"fov\"");
    }
    if (const auto radius = object.optional("lens_radius"); radius && radius->number() != 0.0) {
        failUnsupported(*radius, "a \"lens_radius\" other than 0");
    }
    if (const auto distance = object.optional("focus_distance")) {
        distance->positiveNumber();
    }
    Camera camera;
    if (const auto matrix = object.optional("matrix")) {
        for (const char* other : {"position", "target", "up"}) {
            object.exclude("matrix", other);
        }
        placeByMatrix(camera, *matrix);
    } else {
        placeByTarget(camera, object);
    }
    const double fov = object.number("fov", kDefaultFov);
    if (!(fov > 0.0 && fov < 180.0)) {
        object.required("fov").fail("must be between 0 and 180 degrees, both excluded");
    }
    camera.verticalFov = fov * (std::numbers::pi / 180.0);
    return camera;
}

FilmSettings readFilm(const JsonValue& value) {
    const JsonObject object(value, {"width", "height", "filter"});
    if (const auto filter = object.optional("filter")) {
        static const std::array<std::string, 4> kFilters = {"box", "tent", "gaussian",
                                                            "blackman-harris"};
        if (filter->choice(kFilters) != 0) {
            failUnsupported(*filter, "a filter other than \"box\"");
        }
    }
    FilmSettings film;
    film.width = object.wholeNumber("width", 1, kLargestSide, film.width);
    film.height = object.wholeNumber("height", 1, kLargestSide, film.height);
    return film;
}

RenderDefaults readRender(const JsonValue& value) {
    const JsonObject object(value, {"spp", "max_bounces", "seed"});
    RenderDefaults render;
    render.samplesPerPixel =
        object.wholeNumber("spp", 1, RenderDefaults::kMostSamplesPerPixel, render.samplesPerPixel);
    render.maxBounces =
        object.wholeNumber("max_bounces", 0, RenderDefaults::kMostBounces, render.maxBounces);
    render.seed = object.wholeNumber("seed", 0, kLargestSeed, render.seed);
    return render;
}

} // namespace calotype
