#include "reference/lights.h"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

#include "reference/background_light.h"
#include "reference/shape_light.h"
#include "reference/warp.h"
#include "scene/scene_bounds.h"
#include "settings/light_choice.h"

namespace calotype::reference {
namespace {

constexpr uint64_t kNumbers = uint64_t{1} << 24; ///< possible values of a uniform random number

bool isPositive(double value) { return value > 0.0; }

double luminance(const glm::dvec3& rgb) { return glm::dot(rgb, {0.2126, 0.7152, 0.0722}); }

} // namespace

Lights::Lights(const Scene& scene, const Geometry& geometry, LightChoice choice)
    : scene_(scene), geometry_(geometry), ofPrimitive_(geometry.primitiveCount(), nullptr) {
    for (uint32_t primitive = 0; primitive < geometry.primitiveCount(); ++primitive)
        add(primitive, scene.materials[geometry.materialOf(primitive)]);
    addBackground();
    buildAliasTable(choice);
    if (choice == LightChoice::All)
        for (const std::unique_ptr<Light>& light : lights_)
            light->selectionProbability = 1.0;
    if (choice == LightChoice::Tree)
        buildTree();
}

/// A light that is off emits nothing, but can still be hidden from the camera.
void Lights::add(uint32_t primitive, const Material& material) {
    if (material.emission == glm::dvec3(0.0) && material.visibleToCamera)
        return;
    const PrimitiveName name = geometry_.primitive(primitive);
    auto light = std::make_unique<ShapeLight>(primitive, scene_.shapes[name.shape], name.triangle,
                                              geometry_.areaOf(primitive), material);
    ofPrimitive_[primitive] = light.get();
    powers_.push_back(luminance(material.emission) * light->area() *
                      (light->shinesFromBack() ? 2.0 : 1.0));
    lights_.push_back(std::move(light));
}

/// Its power is the radiance through the sphere around the scene, at most that of all other lights.
void Lights::addBackground() {
    if (scene_.background == glm::dvec3(0.0))
        return;
    const Bounds3d bounds = sceneBounds(scene_);
    const double radius = bounds.isEmpty() ? 1.0 : 0.5 * glm::length(bounds.extent());
    const double power = luminance(scene_.background) * 4.0 * kPi * radius * radius;
    const double others = std::accumulate(powers_.begin(), powers_.end(), 0.0);
    powers_.push_back(others > 0.0 ? std::min(power, others) : power);
    lights_.push_back(std::make_unique<BackgroundLight>(scene_.background));
    infinite_ = lights_.back().get();
}

/// Each emitting light gets one of the random numbers, then its share of the others, rounded down;
/// the rest goes to the lights in turn.
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

void Lights::buildAliasTable(LightChoice choice) {
    if (choice == LightChoice::Uniform)
        for (double& power : powers_)
            power = power > 0.0 ? 1.0 : 0.0;
    // Each light is a column of as many numbers as any other. A column of a light that was dealt
    // fewer is poor, and of one that was dealt more is rich.
    std::vector<uint64_t> numbers = dealNumbers();
    const size_t count = lights_.size();
    std::vector<size_t> poor;
    std::vector<size_t> rich;
    columns_.resize(count);
    for (size_t i = 0; i < count; ++i) {
        const uint64_t first = (i * kNumbers + count - 1) / count;
        const uint64_t end = ((i + 1) * kNumbers + count - 1) / count;
        columns_[i] = {first, end, end, i};
        lights_[i]->selectionProbability = static_cast<double>(numbers[i]) / kNumbers;
        if (numbers[i] != end - first)
            (numbers[i] < end - first ? poor : rich).push_back(i);
    }
    // The rest of a poor column goes to a rich light, which may be poor then.
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

/// A light that is not in the tree does not emit, and has the probability 0.
void Lights::buildTree() {
    std::vector<LightCluster> clusters;
    inTree_.resize(geometry_.primitiveCount());
    for (const PrimitiveLight& light : primitiveLights(scene_)) {
        inTree_[light.primitive] = static_cast<uint32_t>(clusters.size());
        primitiveOfTree_.push_back(light.primitive);
        clusters.push_back(light.cluster);
    }
    tree_ = TreeChoice(buildLightTree(clusters));
}

double Lights::maxRadiance() const {
    double largest = 0.0;
    for (const std::unique_ptr<Light>& light : lights_)
        largest = std::max(largest, light->maxRadiance());
    return largest;
}

/// The greatest numbers choose the infinite light.
Lights::Choice Lights::choose(const LitPoint& point, const glm::dvec2& u) const {
    if (tree_.empty())
        return chooseInTable(u);
    const double number = u.x + u.y / static_cast<double>(kNumbers);
    const double ofInfinite = infinite_ ? infinite_->selectionProbability : 0.0;
    const double ofTree = 1.0 - ofInfinite;
    if (number >= ofTree)
        return {*infinite_, (number - ofTree) / ofInfinite, ofInfinite, ofInfinite};
    const auto chosen = tree_.choose(point, number / ofTree);
    return {*ofPrimitive_[primitiveOfTree_[chosen.light]], chosen.u, chosen.probability * ofTree,
            chosen.withoutNormal * ofTree};
}

double Lights::probability(const Light& light, const glm::dvec3& shadingPoint) const {
    if (!isInTree(light) || light.selectionProbability == 0.0)
        return light.selectionProbability;
    const double ofTree = 1.0 - (infinite_ ? infinite_->selectionProbability : 0.0);
    return ofTree * tree_.probability(shadingPoint, inTree_[*light.primitive()]);
}

/// Through a column of an alias table (Walker 1974, Vose 1991).
Lights::Choice Lights::chooseInTable(const glm::dvec2& u) const {
    const auto number = static_cast<uint64_t>(u.x * kNumbers);
    const size_t own = number * lights_.size() / kNumbers;
    const Column& column = columns_[own];
    const bool isOwn = number < column.aliasFrom;
    const uint64_t first = isOwn ? column.first : column.aliasFrom;
    const uint64_t end = isOwn ? column.aliasFrom : column.end;
    const double place =
        (static_cast<double>(number - first) + u.y) / static_cast<double>(end - first);
    const Light& light = *lights_[isOwn ? own : column.alias];
    return {light, place, light.selectionProbability, light.selectionProbability};
}

} // namespace calotype::reference
