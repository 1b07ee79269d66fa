#include "materials/material_kind.h"

#include <array>

#include "materials/blinn_phong.h"
#include "materials/dielectric.h"
#include "materials/diffuse.h"
#include "materials/metal.h"
#include "materials/nonmetal.h"

namespace calotype {

std::span<const MaterialKind> materialKinds() {
    static const std::array<MaterialKind, 5> kinds = {diffuseKind(), metalKind(), nonmetalKind(),
                                                      blinnPhongKind(), dielectricKind()};
    return kinds;
}

const MaterialKind& kindOf(const Material& material) {
    return materialKinds()[static_cast<size_t>(material.type)];
}

} // namespace calotype
