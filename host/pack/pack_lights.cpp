#include "pack/pack_lights.h"

#include <algorithm>
#include <numbers>

#include <glm/geometric.hpp>

#include "math/greatest.h"
#include "math/luminance.h"
#include "pack/alias_table.h"
#include "pack/pack_material.h"
#include "scene/scene_bounds.h"
#include "shared/specialization.h"

namespace calotype {
namespace {

/// The kernel feature for lights of that kind.
uint32_t featureOf(uint32_t kind) { return shared::kFeatureTriangleLights + kind; }

/// A triangle that is chosen less often is sampled by area, which costs less: the variance of its
/// light comes from the choice (docs/models.md, "Triangle light").
constexpr double kLeastBySolidAngle = 1.0 / 64.0;

// The features of the kinds must follow each other.
constexpr uint32_t kLightKinds = 0
#define LIGHT(id, sort, people) +1
#include "shared/feature_table.h"
    ;
#define LIGHT(id, sort, people) static_assert(shared::kLight##id < kLightKinds);
#include "shared/feature_table.h"

} // namespace

bool LightPacker::isLight(uint32_t materialIndex) const {
    const Material& material = scene_.materials[materialIndex];
    return greatest(material.emission) > 0.0 || !material.visibleToCamera;
}

void LightPacker::add(uint32_t kind, uint32_t materialIndex, uint32_t name, uint32_t number,
                      double area) {
    const Material& material = scene_.materials[materialIndex];
    // Camera rays pass through a hidden light even if it is off.
    const bool shines = greatest(material.emission) > 0.0 && area > 0.0;
    if (!shines && material.visibleToCamera)
        return;
    maxRadiance_ = std::max(maxRadiance_, greatest(material.emission));
    shared::Light light{};
    light.radiance = glm::vec3(material.emission);
    light.kind = kind;
    light.primitive = name;
    light.area = static_cast<float>(area);
    light.flags = (material.emitsFromFrontOnly ? 0 : shared::kLightEmitsFromBack) |
                  (material.visibleToCamera ? 0 : shared::kLightHiddenFromCamera);
    features_.enabled[featureOf(kind)] = true;
    if (!material.visibleToCamera)
        features_.enabled[shared::kFeatureHiddenLights] = true;
    if (isTransparent(material))
        features_.enabled[shared::kFeatureLightAlpha] = true;
    const double sides = material.emitsFromFrontOnly ? 1.0 : 2.0;
    lights_.push_back({light, number, luminance(material.emission) * area * sides});
}

/// The power of the background is its radiance through the sphere around the scene. It is chosen
/// with probability 1/2 at most, however large the scene's ground is: rays that leave surfaces by
/// BSDF sampling find it too.
void LightPacker::addBackground() {
    if (scene_.background == glm::dvec3(0.0))
        return;
    maxRadiance_ = std::max(maxRadiance_, greatest(scene_.background));
    const Bounds3d bounds = sceneBounds(scene_);
    const double radius = bounds.isEmpty() ? 1.0 : 0.5 * glm::length(bounds.extent());
    const double area = 4.0 * std::numbers::pi * radius * radius;
    const double power = luminance(scene_.background) * area;
    double others = 0.0;
    for (const NumberedLight& light : lights_)
        others += light.power;
    shared::Light light{};
    light.radiance = glm::vec3(scene_.background);
    light.kind = shared::kLightBackground;
    light.primitive = shared::kNone;
    lights_.push_back({light, 0, others > 0.0 ? std::min(power, others) : power});
    features_.enabled[featureOf(light.kind)] = true;
}

std::vector<shared::Light> LightPacker::take() {
    std::ranges::sort(lights_, {}, &NumberedLight::number);
    addBackground();
    std::vector<double> powers;
    for (const NumberedLight& light : lights_)
        powers.push_back(choice_ != LightChoice::Uniform || light.power == 0.0 ? light.power : 1.0);
    const std::vector<AliasColumn> columns = buildAliasTable(powers);
    std::vector<shared::Light> packed;
    for (size_t i = 0; i < lights_.size(); ++i) {
        shared::Light light = lights_[i].light;
        light.selectionProbability = static_cast<float>(columns[i].probability);
        light.firstNumber = columns[i].firstNumber;
        light.ownNumbers = columns[i].ownNumbers;
        light.aliasNumbers = columns[i].aliasNumbers;
        light.alias = columns[i].alias;
        if (light.kind == shared::kLightTriangle && columns[i].probability >= kLeastBySolidAngle) {
            light.flags |= shared::kLightBySolidAngle;
            features_.enabled[shared::kFeatureSolidAngleLights] = true;
        }
        packed.push_back(light);
    }
    return packed;
}

} // namespace calotype
