#include "reference/lights.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

#include <glm/geometric.hpp>

#include "reference/sample_shape.h"
#include "reference/warp.h"
#include "scene/scene_bounds.h"
#include "settings/light_choice.h"

namespace calotype::reference {
namespace {

constexpr uint64_t kNumbers = uint64_t{1} << 24; ///< that a uniform random number may be

bool isPositive(double value) { return value > 0.0; }

double luminance(const glm::dvec3& rgb) { return glm::dot(rgb, {0.2126, 0.7152, 0.0722}); }

/// The density 1 / area as one per solid angle (docs/models.md, "Direct light"). Zero edge on, and
/// where the point is the reference itself.
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

/// Each light that shines gets one of the random numbers, and of the others its share, rounded
/// down; what is left goes round in order.
std::vector<uint64_t> Lights::dealNumbers() const {
    std::vector<uint64_t> dealt(powers_.size(), 0);
    const double sum = std::accumulate(powers_.begin(), powers_.end(), 0.0);
    const auto shining = static_cast<uint64_t>(std::ranges::count_if(powers_, isPositive));
    if (shining == 0)
        return dealt;
    const uint64_t shared = kNumbers - std::min(kNumbers, shining);
    uint64_t left = kNumbers;
    for (size_t i = 0; i < powers_.size(); ++i) {
        dealt[i] = static_cast<uint64_t>(powers_[i] / sum * static_cast<double>(shared));
        left -= dealt[i];
    }
    for (size_t i = 0; left > 0; i = (i + 1) % powers_.size())
        if (powers_[i] > 0.0) {
            ++dealt[i];
            --left;
        }
    return dealt;
}

void Lights::buildAliasTable() {
    if (scene_.lightChoice == LightChoice::Uniform)
        for (double& power : powers_)
            power = power > 0.0 ? 1.0 : 0.0;
    std::vector<uint64_t> numbers = dealNumbers();
    const size_t count = lights_.size();
    std::vector<size_t> poor;
    std::vector<size_t> rich;
    columns_.resize(count);
    for (size_t i = 0; i < count; ++i) {
        const uint64_t first = (i * kNumbers + count - 1) / count;
        const uint64_t end = ((i + 1) * kNumbers + count - 1) / count;
        columns_[i] = {first, end, end, i};
        lights_[i].selectionProbability = static_cast<double>(numbers[i]) / kNumbers;
        if (numbers[i] != end - first)
            (numbers[i] < end - first ? poor : rich).push_back(i);
    }
    while (!poor.empty() && !rich.empty()) {
        Column& taker = columns_[poor.back()];
        const size_t giver = rich.back();
        const uint64_t size = columns_[giver].end - columns_[giver].first;
        taker.aliasFrom = taker.first + numbers[poor.back()];
        taker.alias = giver;
        poor.pop_back();
        numbers[giver] -= taker.end - taker.aliasFrom;
        if (numbers[giver] <= size)
            rich.pop_back();
        if (numbers[giver] < size)
            poor.push_back(giver);
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

Lights::Choice Lights::choose(const glm::dvec2& u) const {
    const auto number = static_cast<uint64_t>(u.x * kNumbers);
    const size_t own = number * lights_.size() / kNumbers;
    const Column& column = columns_[own];
    const bool isOwn = number < column.aliasFrom;
    const uint64_t first = isOwn ? column.first : column.aliasFrom;
    const uint64_t end = isOwn ? column.aliasFrom : column.end;
    const double place =
        (static_cast<double>(number - first) + u.y) / static_cast<double>(end - first);
    return {lights_[isOwn ? own : column.alias], place};
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
