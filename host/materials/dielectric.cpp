#include "materials/dielectric.h"

#include "materials/parameters.h"
#include "scene/ranges.h"

namespace calotype {
namespace {

void packDielectric(const Material&, shared::Material& packed) {
    packed.lobes = shared::kLobeDielectric | shared::kColorIsTint;
}

} // namespace

MaterialKind dielectricKind() {
    return {"dielectric",
            "A smooth boundary: Snell's law and exact Fresnel. Emits no light.",
            {{"ior", NumberParameter{&Material::ior, nullptr, ranges::kIndexOfRefraction},
              std::nullopt, "The index of refraction inside."},
             {"exterior_ior",
              NumberParameter{&Material::exteriorIor, nullptr, ranges::kIndexOfRefraction},
              Material().exteriorIor, "The index of refraction outside."},
             {"color", ColorParameter{&Material::color, nullptr, ranges::kShare}, 1.0,
              "A factor for light at each crossing of the boundary."}},
            false,
            packDielectric,
            nullptr,
            nullptr};
}

} // namespace calotype
