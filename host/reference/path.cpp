#include "reference/path.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "reference/bsdf.h"
#include "reference/camera.h"
#include "reference/geometry.h"
#include "reference/lights.h"
#include "reference/warp.h"

namespace calotype::reference {
namespace {

double greatest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

/// The weight of a sample of one strategy if another could have found it too: the power heuristic
/// with exponent 2 (Veach 1997, section 9.2.2).
double powerHeuristic(double pdf, double otherPdf) {
    const double ratio = otherPdf / pdf;
    return 1.0 / (1.0 + ratio * ratio);
}

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isTransparent(const Material& material) {
    return material.opacity < 1.0 || material.alphaTexture != Material::kNoTexture;
}

/// Origins of rays that leave a surface. On the viewer's side they are off the smooth surface.
struct Departure {
    glm::dvec3 viewerSide;
    glm::dvec3 farSide;
};

/// One path, event by event.
class Path {
public:
    Path(const PathSetup& setup, const SampleId& id) : setup_(setup), id_(id) {
        const glm::dvec4 u = cameraNumbers(id);
        const Scene& scene = setup.scene;
        const glm::dvec2 onFilm =
            glm::dvec2(id.pixel) + samplePixel(scene.film.filter, glm::dvec2(u.x, u.y));
        ray_ = cameraRay(scene.camera, setup.imageSize, onFilm, glm::dvec2(u.z, u.w));
        vertex_ = ray_.origin;
    }

    PathSample run() {
        while (extend()) {
        }
        result_.isFinite = isFinite(result_.radiance) && isFinite(throughput_);
        return result_;
    }

private:
    /// Traces the ray to the next surface. False if the path ends.
    bool extend() {
        ++result_.rays;
        const std::optional<Hit> hit = setup_.geometry.closest(ray_);
        if (!hit) {
            result_.showsNothing = bounce_ == 0 && setup_.transport.hidesBackground;
            if (!result_.showsNothing)
                addInfinite();
            return false;
        }
        const Surface surface = setup_.geometry.surface(*hit, ray_);
        if (passesThrough(surface)) {
            ray_.origin = leaveSurface(surface, ray_.direction);
            return true;
        }
        addEmitted(surface);
        return bounce_ < setup_.maxBounces && scatter(surface);
    }

    /// The weight of light found at the ray's end by BSDF sampling, if light sampling would have
    /// found it with the density `lightPdf`.
    double bsdfShare(double lightPdf) const {
        const bool isOnlyStrategy = bounce_ == 0 || std::isinf(bsdfPdf_) || lightPdf == 0.0;
        if (isOnlyStrategy)
            return 1.0;
        return setup_.transport.usesMis ? powerHeuristic(bsdfPdf_, lightPdf) : 0.0;
    }

    /// Adds light found after this many events, clamped.
    void addLight(const glm::dvec3& found, uint32_t events) {
        const double limit = setup_.transport.indirectClamp;
        const double most = greatest(found);
        result_.radiance += events > 1 && most > limit ? found * (limit / most) : found;
    }

    void addInfinite() {
        if (const Light* light = setup_.lights.infinite())
            addFound(*light, {});
    }

    void addEmitted(const Surface& surface) {
        if (const Light* light = setup_.lights.ofPrimitive(surface.primitive))
            addFound(*light, {surface.position, surface.ng});
    }

    /// Adds light that the ray hit.
    void addFound(const Light& light, const Light::Point& point) {
        const double pdf =
            light.pdf(vertex_, ray_.direction, point) * setup_.lights.probability(light, vertex_);
        addLight(throughput_ * light.radiance(ray_.direction, point) * bsdfShare(pdf), bounce_);
    }

    bool passesThrough(const Surface& surface) const {
        const Light* light = setup_.lights.ofPrimitive(surface.primitive);
        if (bounce_ == 0 && light && light->isHiddenFromCamera())
            return true;
        const Material& material = setup_.scene.materials[surface.material];
        if (!isTransparent(material))
            return false;
        const uint32_t fromBehind = glm::dot(ray_.direction, surface.ng) > 0.0 ? 1 : 0;
        const double u = alphaNumber(id_, bounce_, 2 * surface.primitive + fromBehind);
        return u >= alphaAt(material, setup_.textures, surface.uv);
    }

    /// Adds the direct light of the surface and samples the next direction. False if the path ends.
    bool scatter(const Surface& surface) {
        const Material& material = setup_.scene.materials[surface.material];
        const Bsdf bsdf(material, setup_.textures, surface, -ray_.direction, setup_.lobesOf);
        const Departure from{offsetFrom(surface.position + surface.toSmooth, bsdf.ng()),
                             offsetFrom(surface.position, -bsdf.ng())};
        if (!setup_.lights.empty() && !bsdf.isSpecular())
            addLight(throughput_ * directLight(surface, bsdf, from), bounce_ + 1);
        const glm::dvec4 u = bounceNumbers(id_, bounce_, BounceDimension::Bsdf);
        const Bsdf::Sample scattered = bsdf.sample(glm::dvec3(u));
        throughput_ *= scattered.weight;
        vertex_ = scattered.crosses ? from.farSide : from.viewerSide;
        ray_ = {vertex_, glm::normalize(scattered.wi)}; // otherwise rounding errors accumulate
        bsdfPdf_ = scattered.pdf;
        radianceScale_ *= scattered.eta * scattered.eta;
        ++bounce_;
        return survives(u.w);
    }

    /// Russian roulette, from the third event on, for paths with a throughput below a quarter. The
    /// scaling of radiance inside glass does not count.
    bool survives(double u) {
        constexpr uint32_t kFirstEvent = 3;
        constexpr double kQuarter = 0.25;
        if (setup_.transport.usesRoulette && bounce_ >= kFirstEvent) {
            const double chance = std::min(greatest(throughput_) * radianceScale_ / kQuarter, 1.0);
            throughput_ = u >= chance ? glm::dvec3(0.0) : throughput_ / chance;
        }
        return greatest(throughput_) > 0.0;
    }

    /// Whether the surface's whole primitive is in or below its tangent plane there, on the side of
    /// the normal `outward`: true except inside a closed quadric.
    bool isConvexTowards(const Surface& surface, const glm::dvec3& outward) const {
        const PrimitiveName name = setup_.geometry.primitive(surface.primitive);
        const auto& shape = setup_.scene.shapes[name.shape].geometry;
        const bool isFlat =
            std::holds_alternative<Mesh>(shape) || std::holds_alternative<Disk>(shape);
        return isFlat || glm::dot(outward, surface.ng) > 0.0;
    }

    /// Light from one point on the chosen light, or on each light, scattered towards the viewer.
    glm::dvec3 directLight(const Surface& surface, const Bsdf& bsdf, const Departure& from) {
        if (setup_.transport.lightChoice != LightChoice::All) {
            const glm::dvec4 u = bounceNumbers(id_, bounce_, BounceDimension::Light);
            LitPoint point{from.viewerSide};
            if (!bsdf.transmits())
                point.normal = bsdf.ns();
            const Lights::Choice choice = setup_.lights.choose(point, glm::dvec2(u.x, u.z));
            return lightFrom(choice, surface, bsdf, from, u.y);
        }
        glm::dvec3 sum(0.0);
        uint32_t number = 0;
        for (const std::unique_ptr<Light>& light : setup_.lights.all()) {
            const glm::dvec2 u(lightNumbers(id_, bounce_, number++));
            sum += lightFrom({*light, u.x, 1.0, 1.0}, surface, bsdf, from, u.y);
        }
        return sum;
    }

    /// Samples the light from the viewer's side, or from the far side if it is there and the
    /// material transmits. A ray that hits the light does not know with which probability it was
    /// chosen here, but the one without the normal, for its own side: both weights have that.
    glm::dvec3 lightFrom(const Lights::Choice& choice, const Surface& surface, const Bsdf& bsdf,
                         const Departure& from, double u2) {
        const Light& light = choice.light;
        const glm::dvec2 u(choice.u, u2);
        double chanceForMis = choice.probabilityForMis;
        glm::dvec3 outward = bsdf.ng();
        Light::Sample sample = light.sample(from.viewerSide, u);
        Ray ray = rayTowards(light, sample, from.viewerSide);
        if (bsdf.transmits() && glm::dot(ray.direction, outward) < 0.0) {
            outward = -outward;
            sample = light.sample(from.farSide, u);
            ray = rayTowards(light, sample, from.farSide);
            chanceForMis = setup_.lights.probability(light, from.farSide);
        }
        if (light.primitive() == surface.primitive && isConvexTowards(surface, outward))
            return glm::dvec3(0.0);
        if (sample.pdf <= 0.0)
            return glm::dvec3(0.0);
        if (ray.length == 0.0) // the light touches the surface: nothing is between them
            return glm::dvec3(0.0);
        const Bsdf::Value scattered = bsdf.evaluate(ray.direction);
        const glm::dvec3 radiance = scattered.value * arrivingRadiance(light, sample.point, ray);
        if (greatest(radiance) <= 0.0)
            return glm::dvec3(0.0);
        const double share = setup_.transport.usesMis
                                 ? powerHeuristic(sample.pdf * chanceForMis, scattered.pdf)
                                 : 1.0;
        return radiance * (transmittance(ray, light) * share / (sample.pdf * choice.probability));
    }

    static Ray rayTowards(const Light& light, const Light::Sample& sample,
                          const glm::dvec3& origin) {
        if (!light.primitive())
            return {origin, sample.wi};
        const Light::Point& point = sample.point;
        const double side = glm::dot(origin - point.position, point.normal) < 0.0 ? -1.0 : 1.0;
        const glm::dvec3 way = offsetFrom(point.position, side * point.normal) - origin;
        const double length = glm::length(way);
        return {origin, length > 0.0 ? way / length : -point.normal, length};
    }

    /// The radiance of the light along the ray, with the alpha of its own surface.
    glm::dvec3 arrivingRadiance(const Light& light, const Light::Point& point,
                                const Ray& ray) const {
        const glm::dvec3 radiance = light.radiance(ray.direction, point);
        if (!light.primitive())
            return radiance;
        const Material& material =
            setup_.scene.materials[setup_.geometry.materialOf(*light.primitive())];
        if (!isTransparent(material))
            return radiance;
        const glm::dvec2 uv = setup_.geometry.uvAt(*light.primitive(), point.position);
        return radiance * alphaAt(material, setup_.textures, uv);
    }

    /// The share of light that passes along the ray: the product of 1 - alpha over all surfaces
    /// except the light's own.
    double transmittance(Ray ray, const Light& light) {
        const glm::dvec3 end = ray.origin + ray.length * ray.direction;
        double share = 1.0;
        while (share > 0.0) {
            ++result_.rays;
            const std::optional<Hit> hit = setup_.geometry.closest(ray);
            if (!hit)
                break;
            const Surface surface = setup_.geometry.surface(*hit, ray);
            if (surface.primitive != light.primitive())
                share *= 1.0 - opacityAt(surface);
            ray.origin = leaveSurface(surface, ray.direction);
            if (light.primitive())
                ray.length = glm::dot(end - ray.origin, ray.direction);
        }
        return share;
    }

    double opacityAt(const Surface& surface) const {
        const Material& material = setup_.scene.materials[surface.material];
        return alphaAt(material, setup_.textures, surface.uv);
    }

    const PathSetup& setup_;
    SampleId id_;
    Ray ray_;
    glm::dvec3 vertex_{0.0}; ///< where the last event sent the ray from
    glm::dvec3 throughput_{1.0};
    uint32_t bounce_ = 0;
    double radianceScale_ = 1.0; ///< by which refraction has divided the throughput so far
    double bsdfPdf_ = 0.0;       ///< of the ray's direction, per solid angle
    PathSample result_;
};

} // namespace

PathSample tracePath(const PathSetup& setup, const SampleId& id) { return Path(setup, id).run(); }

} // namespace calotype::reference
