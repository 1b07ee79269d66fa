#include "scene/material_energy.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace calotype {
namespace {

/// Weights that add up to one in decimal may not do so in binary.
constexpr double kRounding = 1e-9;
/// What an albedo must exceed one by: the error of its integration.
constexpr double kTolerance = 0.002;
constexpr int kAngles = 20; ///< from a cosine of 1 / 20 (87 degrees) to 1

double shadowing(double cosL, double cosV, double roughness, Masking masking) {
    if (masking == Masking::Schlick) {
        const double k = (roughness + 1.0) * (roughness + 1.0) / 8.0;
        return cosL * cosV / ((cosL * (1.0 - k) + k) * (cosV * (1.0 - k) + k));
    }
    const double alpha2 = std::pow(roughness, 4.0);
    const auto root = [&](double c) { return std::sqrt(alpha2 + (1.0 - alpha2) * c * c); };
    return 2.0 * cosL * cosV / (cosL * root(cosV) + cosV * root(cosL));
}

std::string percent(double share) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << 100.0 * share << " %";
    return text.str();
}

std::optional<std::string> blinnPhongWarning(const Material& material) {
    const double factor = material.normalize ? 1.0 : 4.0;
    if (material.kd + factor * material.ks <= 1.0 + kRounding) {
        return std::nullopt;
    }
    return std::string("this blinn_phong can reflect more light than it receives, since ") +
           (material.normalize ? "kd + ks > 1; lower kd or ks"
                               : "kd + 4 ks > 1; lower kd or ks, or set \"normalize\": true");
}

std::optional<std::string> nonmetalWarning(const Material& material) {
    const bool texturedColor = material.colorTexture != Material::kNoTexture;
    if (texturedColor || material.specularTexture != Material::kNoTexture) {
        return std::nullopt;
    }
    const glm::dvec3& color = material.color;
    const double diffuse = (1.0 - material.specular) * std::max({color.x, color.y, color.z});
    double most = 0.0;
    for (int i = 1; i <= kAngles; ++i) {
        most = std::max(most, diffuse + ggxAlbedo(double(i) / kAngles, material.roughness,
                                                  material.specular, material.masking));
    }
    if (most <= 1.0 + kTolerance) {
        return std::nullopt;
    }
    return "this nonmetal reflects up to " + percent(most) +
           " of the light that it receives, at grazing angles; choose a darker colour";
}

} // namespace

/// Half vectors of density D n.h (eq. 1.31, 1.32) on a regular grid: each stands for
/// F G v.h / (n.v n.h) of the light.
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
            const double azimuth = std::numbers::pi * (j + 0.5) / kAzimuthal; // half a turn does
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

std::optional<std::string> energyWarning(const Material& material) {
    switch (material.type) {
    case MaterialType::BlinnPhong:
        return blinnPhongWarning(material);
    case MaterialType::Nonmetal:
        return nonmetalWarning(material);
    case MaterialType::Diffuse:
    case MaterialType::Metal:
    case MaterialType::Dielectric:
        break;
    }
    return std::nullopt;
}

} // namespace calotype
