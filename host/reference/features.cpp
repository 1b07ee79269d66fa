#include "reference/features.h"

#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "reference/bsdf.h"
#include "reference/camera.h"
#include "reference/geometry.h"
#include "reference/lights.h"

namespace calotype::reference {
namespace {

/// Mirrors and clear surfaces that a ray is followed through.
constexpr uint32_t kMostEvents = 8;

bool isBlack(const glm::dvec3& color) {
    return glm::all(glm::lessThanEqual(color, {0.0, 0.0, 0.0}));
}

/// One ray, from surface to surface.
class FeatureRay {
public:
    FeatureRay(const PathSetup& setup, const SampleId& id) : setup_(setup), id_(id) {
        const glm::dvec4 u = cameraNumbers(id);
        const glm::dvec2 onFilm =
            glm::dvec2(id.pixel) + samplePixel(setup.scene.film.filter, glm::dvec2(u.x, u.y));
        ray_ = cameraRay(setup.scene.camera, setup.imageSize, onFilm, glm::dvec2(u.z, u.w));
    }

    RayFeatures run() {
        while (extend()) {
        }
        return {features_, primitive_};
    }

private:
    /// Traces the ray to the next surface. False if the search ends there.
    bool extend() {
        const std::optional<Hit> hit = setup_.geometry.closest(ray_);
        if (!hit) {
            const bool isHidden = events_ == 0 && setup_.transport.hidesBackground;
            if (const Light* light = setup_.lights.infinite(); light && !isHidden)
                features_.meanAlbedo = glm::vec3(throughput_ * shown(*light, {}));
            return false;
        }
        const Surface surface = setup_.geometry.surface(*hit, ray_);
        const Light* light = setup_.lights.ofPrimitive(surface.primitive);
        const Material& material = setup_.scene.materials[surface.material];
        if (events_ == 0 && light && light->isHiddenFromCamera())
            return passThrough(surface);
        const uint32_t fromBehind = glm::dot(ray_.direction, surface.ng) > 0.0 ? 1 : 0;
        const double alpha = alphaAt(material, setup_.textures, surface.uv);
        if (alpha < 1.0 && alphaNumber(id_, events_, 2 * surface.primitive + fromBehind) >= alpha)
            return passThrough(surface);
        if (events_ == 0) {
            const glm::dvec3 way = surface.position - setup_.scene.camera.position;
            features_.meanDepth = static_cast<float>(glm::dot(way, setup_.scene.camera.forward));
            features_.alpha = 1.0f;
            primitive_ = surface.primitive;
        }
        const glm::dvec3 emitted =
            light ? shown(*light, {surface.position, surface.ng}) : glm::dvec3(0.0);
        const Bsdf bsdf(material, setup_.textures, surface, -ray_.direction, setup_.lobesOf);
        if (isBlack(emitted) && bsdf.isSpecular() && events_ < kMostEvents && follow(bsdf, surface))
            return true;
        const bool isClear = material.type == MaterialType::Dielectric;
        const glm::dvec3 color =
            isClear ? glm::dvec3(1.0) : colorAt(material, setup_.textures, surface.uv);
        const double side = fromBehind == 1 ? -1.0 : 1.0;
        features_.meanAlbedo = glm::vec3(throughput_ * glm::max(emitted, color));
        features_.meanNormal = glm::vec3(side * shadingNormal(material, setup_.textures, surface));
        return false;
    }

    bool passThrough(const Surface& surface) {
        ray_.origin = leaveSurface(surface, ray_.direction);
        return true;
    }

    /// The radiance of a light as far as a display shows it.
    glm::dvec3 shown(const Light& light, const Light::Point& point) const {
        return glm::clamp(light.radiance(ray_.direction, point), 0.0, 1.0);
    }

    /// Mirrors or refracts the ray. False if no light goes on.
    bool follow(const Bsdf& bsdf, const Surface& surface) {
        const glm::dvec4 u = bounceNumbers(id_, events_, BounceDimension::Bsdf);
        const Bsdf::Sample scattered = bsdf.sample(glm::dvec3(u));
        throughput_ *= scattered.weight;
        ray_ = {offsetFrom(surface.position, scattered.crosses ? -bsdf.ng() : bsdf.ng()),
                glm::normalize(scattered.wi)};
        ++events_;
        return !isBlack(throughput_);
    }

    const PathSetup& setup_;
    SampleId id_;
    Ray ray_;
    glm::dvec3 throughput_{1.0};
    uint32_t events_ = 0;
    Features features_;
    uint32_t primitive_ = kNoPrimitive; ///< of the first surface that the ray shows
};

} // namespace

RayFeatures traceFeatures(const PathSetup& setup, const SampleId& id) {
    return FeatureRay(setup, id).run();
}

} // namespace calotype::reference
