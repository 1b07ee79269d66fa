#include "materials/diffuse.h"

#include "materials/parameters.h"

namespace calotype {
namespace {

/// A black surface has no lobe, so that paths end there.
void packDiffuse(const Material& material, shared::Material& packed) {
    packed.lobes = material.color == glm::dvec3(0.0) ? 0 : shared::kLobeDiffuse;
}

} // namespace

MaterialKind diffuseKind() {
    return {"diffuse",
            "color / pi in every direction.",
            {texturedColor("The share of light that is reflected.")},
            true,
            packDiffuse,
            nullptr,
            nullptr};
}

} // namespace calotype
