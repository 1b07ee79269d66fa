#include "materials/excess_albedo.h"

#include <iomanip>
#include <sstream>

#include "materials/material_kind.h"
#include "math/greatest.h"

namespace calotype {

std::optional<double> excessAlbedo(const Material& material, TextureRanges& textures) {
    const MaterialKind& kind = kindOf(material);
    return kind.excessAlbedo ? kind.excessAlbedo(material, textures) : std::nullopt;
}

double brightestChannel(const Material& material, TextureRanges& textures) {
    return greatest(material.color * textures.brightest(material.colorTexture));
}

std::optional<double> whereAbove(double limit, double albedo) {
    return albedo > limit ? std::optional(albedo) : std::nullopt;
}

std::string albedoText(double albedo) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << 100.0 * albedo << " %";
    return text.str();
}

} // namespace calotype
