#include "materials/ggx.h"

#include <cmath>
#include <numbers>

#include "shared/scene_structs.h"

namespace calotype {
namespace {

double shadowing(double cosL, double cosV, double roughness, Masking masking) {
    if (masking == Masking::Schlick) {
        const double k = (roughness + 1.0) * (roughness + 1.0) / 8.0;
        return cosL * cosV / ((cosL * (1.0 - k) + k) * (cosV * (1.0 - k) + k));
    }
    const double alpha2 = std::pow(roughness, 4.0);
    const auto root = [&](double c) { return std::sqrt(alpha2 + (1.0 - alpha2) * c * c); };
    return 2.0 * cosL * cosV / (cosL * root(cosV) + cosV * root(cosL));
}

} // namespace

uint32_t ggxLobe(const Material& material) {
    return shared::kLobeGgx | (material.masking == Masking::Smith ? shared::kSmithMasking : 0);
}

/// Half vectors of density D n.h on a regular grid: each has the weight F G v.h / (n.v n.h) of the
/// light (docs/models.md, "GGX").
double ggxAlbedo(double cosine, double roughness, double f0, Masking masking) {
    constexpr int kPolar = 32;
    constexpr int kAzimuthal = 16;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    double sum = 0.0;
    for (int i = 0; i < kPolar; ++i) {
        const double u = (i + 0.5) / kPolar;
        const double tangent = roughness * roughness * std::sqrt(u / (1.0 - u));
        const double cosH = 1.0 / std::sqrt(1.0 + tangent * tangent);
        for (int j = 0; j < kAzimuthal; ++j) {
            const double azimuth = std::numbers::pi * (j + 0.5) / kAzimuthal; // half a turn is all
            const double vDotH = cosine * cosH + sine * tangent * cosH * std::cos(azimuth);
            const double cosL = 2.0 * vDotH * cosH - cosine;
            if (vDotH > 0.0 && cosL > 0.0) {
                const double fresnel = f0 + (1.0 - f0) * std::pow(1.0 - vDotH, 5.0);
                sum +=
                    fresnel * shadowing(cosL, cosine, roughness, masking) * vDotH / (cosine * cosH);
            }
        }
    }
    return sum / (kPolar * kAzimuthal);
}

} // namespace calotype
