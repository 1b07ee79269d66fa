#include "reference/lights.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

#include <glm/geometric.hpp>

#include "reference/sample_shape.h"
#include "reference/warp.h"
#include "scene/scene_bounds.h"

namespace calotype::reference {
namespace {

double luminance(const glm::dvec3& rgb) { return glm::dot(rgb, {0.2126, 0.7152, 0.0722}); }

/// A density per area, 1 / area, as one per solid angle (report eq. 1.36). Zero edge on, and where
/// the point is the reference itself.
double solidAnglePdf(double area, const glm::dvec3& reference, const glm::dvec3& position,
                     const glm::dvec3& normal) {
    const glm::dvec3 d = position - reference;
    if (d == glm::dvec3(0.0))
        return 0.0;
    const double cosTheta = std::abs(glm::dot(glm::normalize(d), normal));
    return cosTheta > 0.0 ? glm::dot(d, d) / (cosTheta * area) : 0.0;
}

/// Whether a closed shape hides its own point, whose outward normal is given, from `reference`.
template <typename Geometry>
bool hidesItself(const Geometry& geometry, const glm::dvec3& reference, const glm::dvec3& position,
                 const glm::dvec3& normal) {
    if constexpr (std::is_same_v<Geometry, Disk> || std::is_same_v<Geometry, Mesh>)
        return false;
    else
        return glm::dot(reference - position, normal) < 0.0 && !contains(geometry, reference);
}

/// Spheres are sampled by the cone in which they are seen, from outside.
template <typename Geometry>
bool isSeenAsCone(const Geometry& geometry, const glm::dvec3& reference) {
    if constexpr (std::is_same_v<Geometry, Sphere>)
        return !contains(geometry, reference);
    else
        return false;
}

} // namespace

glm::dvec3 Light::emitted(const glm::dvec3& normal, const glm::dvec3& w) const {
    return glm::dot(normal, w) > 0.0 || shinesFromBack ? radiance : glm::dvec3(0.0);
}

Lights::Lights(const Scene& scene, const Geometry& geometry)
    : scene_(scene), geometry_(geometry), ofPrimitive_(geometry.primitiveCount(), kNone) {
    for (uint32_t primitive = 0; primitive < geometry.primitiveCount(); ++primitive)
        add(primitive, scene.materials[geometry.materialOf(primitive)]);
    addBackground();
    buildAliasTable();
    if (scene.lightChoice == LightChoice::All)
        for (Light& light : lights_)
            light.selectionProbability = 1.0;
}

/// A lamp that is off is no light, but still hidden from the camera if it says so.
void Lights::add(uint32_t primitive, const Material& material) {
    if (material.emission == glm::dvec3(0.0) && material.visibleToCamera)
        return;
    Light light;
    light.primitive = primitive;
    light.radiance = material.emission;
    light.area = geometry_.areaOf(primitive);
    light.shinesFromBack = !material.emitsFromFrontOnly;
    light.isHiddenFromCamera = !material.visibleToCamera;
    ofPrimitive_[primitive] = static_cast<uint32_t>(lights_.size());
    powers_.push_back(luminance(light.radiance) * light.area * (light.shinesFromBack ? 2.0 : 1.0));
    lights_.push_back(light);
}

/// What the background sends through the sphere about the scene, but at most as much as all others.
void Lights::addBackground() {
    if (scene_.background == glm::dvec3(0.0))
        return;
    const Bounds3d bounds = sceneBounds(scene_);
    const double radius = bounds.isEmpty() ? 1.0 : 0.5 * glm::length(bounds.extent());
    const double power = luminance(scene_.background) * 4.0 * kPi * radius * radius;
    const double others = std::accumulate(powers_.begin(), powers_.end(), 0.0);
    powers_.push_back(others > 0.0 ? std::min(power, others) : power);
    Light light;
    light.radiance = scene_.background;
    lights_.push_back(light);
}

void Lights::buildAliasTable() {
    if (scene_.lightChoice == LightChoice::Uniform)
        for (double& power : powers_)
            power = power > 0.0 ? 1.0 : 0.0;
    const double sum = std::accumulate(powers_.begin(), powers_.end(), 0.0);
    const size_t count = lights_.size();
    std::vector<double> filled(count);
    std::vector<size_t> poor;
    std::vector<size_t> rich;
    columns_.resize(count);
    for (size_t i = 0; i < count; ++i) {
        filled[i] = sum > 0.0 ? powers_[i] / sum * static_cast<double>(count) : 0.0;
        columns_[i].alias = i;
        (filled[i] < 1.0 ? poor : rich).push_back(i);
    }
    while (!poor.empty() && !rich.empty()) {
        const size_t taker = poor.back();
        const size_t giver = rich.back();
        poor.pop_back();
        columns_[taker] = {filled[taker], giver};
        filled[giver] -= 1.0 - filled[taker];
        if (filled[giver] < 1.0) {
            rich.pop_back();
            poor.push_back(giver);
        }
    }
    addUpProbabilities();
}

/// The random numbers have 24 bits, so that they choose a column, and within it the column's own
/// light, by whole multiples of 2^-24 only.
void Lights::addUpProbabilities() {
    const double steps = 0x1p24;
    const double count = static_cast<double>(columns_.size());
    const auto firstStep = [&](double column) { return std::ceil(column * steps / count); };
    for (size_t i = 0; i < columns_.size(); ++i) {
        const auto column = static_cast<double>(i);
        const double probability = (firstStep(column + 1.0) - firstStep(column)) / steps;
        const double own = std::ceil(columns_[i].threshold * steps) / steps;
        lights_[i].selectionProbability += probability * own;
        lights_[columns_[i].alias].selectionProbability += probability * (1.0 - own);
    }
}

double Lights::maxRadiance() const {
    double largest = 0.0;
    for (const Light& light : lights_)
        largest = std::max({largest, light.radiance.x, light.radiance.y, light.radiance.z});
    return largest;
}

const Light* Lights::ofPrimitive(uint32_t primitive) const {
    const uint32_t index = ofPrimitive_[primitive];
    return index == kNone ? nullptr : &lights_[index];
}

const Light* Lights::background() const {
    return !lights_.empty() && !lights_.back().primitive ? &lights_.back() : nullptr;
}

const Light& Lights::choose(const glm::dvec2& u) const {
    const auto column = static_cast<size_t>(u.x * static_cast<double>(lights_.size()));
    return lights_[u.y < columns_[column].threshold ? column : columns_[column].alias];
}

const Shape& Lights::shapeOf(const Light& light) const {
    return scene_.shapes[geometry_.primitive(*light.primitive).shape];
}

LightSample Lights::sample(const Light& light, const glm::dvec3& reference,
                           const glm::dvec2& u) const {
    if (!light.primitive)
        return {warpToSphere(u), {}, 1.0 / (4.0 * kPi)};
    const ShapePoint point = std::visit(
        [&]<typename G>(const G& geometry) {
            if constexpr (std::is_same_v<G, Mesh>) {
                return samplePoint(geometry, geometry_.primitive(*light.primitive).triangle, u);
            } else if constexpr (std::is_same_v<G, Sphere>) {
                return isSeenAsCone(geometry, reference) ? sampleSeenSphere(geometry, reference, u)
                                                         : samplePoint(geometry, u);
            } else {
                return samplePoint(geometry, u);
            }
        },
        shapeOf(light).geometry);
    return {point.position, point.normal, pdf(light, reference, point.position, point.normal)};
}

double Lights::pdf(const Light& light, const glm::dvec3& reference, const glm::dvec3& position,
                   const glm::dvec3& normal) const {
    return std::visit(
        [&](const auto& geometry) {
            if (isSeenAsCone(geometry, reference)) {
                const bool isFarSide = glm::dot(reference - position, normal) < 0.0;
                return isFarSide
                           ? 0.0
                           : sphereConePdf(std::get<Sphere>(shapeOf(light).geometry), reference);
            }
            return hidesItself(geometry, reference, position, normal)
                       ? 0.0
                       : solidAnglePdf(light.area, reference, position, normal);
        },
        shapeOf(light).geometry);
}

} // namespace calotype::reference
