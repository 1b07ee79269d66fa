#include "materials/metal.h"

#include "materials/ggx.h"
#include "materials/parameters.h"

namespace calotype {
namespace {

void packMetal(const Material& material, shared::Material& packed) {
    packed.lobes = ggxLobe(material) | shared::kColorIsF0;
}

} // namespace

MaterialKind metalKind() {
    return {"metal",
            "A GGX lobe with F0 = color and alpha = roughness^2.",
            {texturedColor("The share of light that is reflected at normal incidence."),
             roughnessParameter(), maskingParameter()},
            true,
            packMetal,
            nullptr,
            nullptr};
}

} // namespace calotype
