#include "materials/parameters.h"

#include <array>

#include "scene/ranges.h"

namespace calotype {
namespace {

/// In the order of Masking.
const std::array<std::string, 2> kMaskings = {"schlick", "smith"};
const std::array<std::string, 2> kSides = {"both", "front"};

void setMasking(Material& material, size_t index) {
    material.masking = static_cast<Masking>(index);
}

void setSide(Material& material, size_t index) { material.emitsFromFrontOnly = index == 1; }

} // namespace

MaterialParameter texturedColor(const std::string& description) {
    return {"color", ColorParameter{&Material::color, &Material::colorTexture, ranges::kShare},
            std::nullopt, description};
}

MaterialParameter roughnessParameter() {
    return {"roughness",
            NumberParameter{&Material::roughness, &Material::roughnessTexture, ranges::kShare},
            std::nullopt, "The square root of GGX's alpha: 0 is a mirror."};
}

MaterialParameter maskingParameter() {
    return {"masking", ChoiceParameter{kMaskings, setMasking}, 0.0,
            "smith is the exact height-correlated term."};
}

MaterialParameter emissionParameter() {
    return {"emission", ColorParameter{&Material::emission, nullptr, ranges::kRadiance}, 0.0,
            "The radiance that makes every shape of the material a light.", "W/(m^2 sr)"};
}

MaterialParameter emissionSideParameter() {
    return {"emission_side", ChoiceParameter{kSides, setSide}, 0.0, "The sides that shine."};
}

} // namespace calotype
