#include "read/json/settings.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "image/image.h"
#include "math/affine_transform.h"
#include "read/json/transform.h"
#include "settings/limits.h"

namespace calotype {
namespace {

/// In the order of Projection.
const std::array<std::string, 2> kProjections = {"perspective", "orthographic"};
/// In the order of FilmFilter.
const std::array<std::string, 4> kFilters = {"box", "tent", "gaussian", "blackman-harris"};
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

/// The opening of the view: an angle in perspective, else a height.
void readView(const JsonObject& object, Camera& camera) {
    if (const auto type = object.optional("type")) {
        camera.projection = static_cast<Projection>(type->choice(kProjections));
    }
    const auto height = object.optional("height");
    const auto fov = object.optional("fov");
    if (camera.projection == Projection::Orthographic) {
        if (fov) {
            fov->fail("belongs to a perspective camera; this one is orthographic and has "
                      "\"height\"");
        }
        camera.viewHeight = object.required("height").positiveNumber();
        return;
    }
    if (height) {
        height->fail("belongs to an orthographic camera; this one is in perspective and has "
                     "\"fov\"");
    }
    const double degrees = fov ? fov->number() : kDefaultFov;
    if (!(degrees > 0.0 && degrees < 180.0)) {
        fov->fail("must be between 0 and 180 degrees, both excluded");
    }
    camera.verticalFov = degrees * (std::numbers::pi / 180.0);
}

/// A thin lens; without a distance it is in focus at the target.
void readLens(const JsonObject& object, Camera& camera) {
    if (const auto radius = object.optional("lens_radius")) {
        camera.lensRadius = radius->numberIn(0.0, HUGE_VAL);
    }
    if (const auto distance = object.optional("focus_distance")) {
        camera.focusDistance = distance->positiveNumber();
    } else if (const auto target = object.optional("target")) {
        camera.focusDistance = glm::dot(camera.forward, target->vector() - camera.position);
    } else if (camera.lensRadius > 0.0) {
        object.value().fail("lacks \"focus_distance\", which a camera with a \"lens_radius\" and "
                            "without a \"target\" needs");
    }
}

} // namespace

Camera readCamera(const JsonValue& value) {
    const JsonObject object(value, {"type", "position", "target", "up", "matrix", "fov", "height",
                                    "lens_radius", "focus_distance"});
    Camera camera;
    if (const auto matrix = object.optional("matrix")) {
        for (const char* other : {"position", "target", "up"}) {
            object.exclude("matrix", other);
        }
        placeByMatrix(camera, *matrix);
    } else {
        placeByTarget(camera, object);
    }
    readView(object, camera);
    readLens(object, camera);
    return camera;
}

FilmSettings readFilm(const JsonValue& value) {
    const JsonObject object(value, {"width", "height", "filter"});
    FilmSettings film;
    film.width = object.wholeNumber("width", 1, kLargestPictureSide, film.width);
    film.height = object.wholeNumber("height", 1, kLargestPictureSide, film.height);
    if (const auto filter = object.optional("filter")) {
        film.filter = static_cast<FilmFilter>(filter->choice(kFilters));
    }
    return film;
}

RenderDefaults readRender(const JsonValue& value) {
    const JsonObject object(value, {"spp", "max_bounces", "seed"});
    RenderDefaults render;
    render.samplesPerPixel =
        object.wholeNumber("spp", 1, kMostSamplesPerPixel, render.samplesPerPixel);
    render.maxBounces = object.wholeNumber("max_bounces", 0, kMostBounces, render.maxBounces);
    render.seed = object.wholeNumber("seed", 0, kLargestSeed, render.seed);
    return render;
}

} // namespace calotype
