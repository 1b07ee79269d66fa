#include "materials/material_energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

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

double largest(const glm::dvec3& color) { return std::max({color.x, color.y, color.z}); }

double brightestColor(const Material& material, TextureRanges& textures) {
    return largest(material.color * textures.brightest(material.colorTexture));
}

double blinnPhongAlbedo(const Material& material, TextureRanges& textures) {
    const double brightest = isJudgedByWeights(material) ? 1.0 : brightestColor(material, textures);
    return material.kd * brightest + (material.normalize ? 1.0 : 4.0) * material.ks;
}

/// Of F0 the least counts: where the albedo, which is linear in it, exceeds one at all, it falls
/// with it, since at an F0 of one it does not.
double nonmetalAlbedo(const Material& material, TextureRanges& textures) {
    const double f0 = material.specular * textures.scalars(material.specularTexture).least;
    const double diffuse = (1.0 - f0) * brightestColor(material, textures);
    const ScalarRange share = textures.scalars(material.roughnessTexture);
    double most = 0.0;
    for (const double end : std::set{share.least, share.greatest}) {
        const double roughness = material.roughness * end;
        for (int i = 1; i <= kAngles; ++i) {
            most = std::max(
                most, diffuse + ggxAlbedo(double(i) / kAngles, roughness, f0, material.masking));
        }
    }
    return most;
}

std::optional<double> whereAbove(double limit, double albedo) {
    return albedo > limit ? std::optional(albedo) : std::nullopt;
}

} // namespace

/// Half vectors of density D n.h on a regular grid: each stands for F G v.h / (n.v n.h) of the
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

bool isJudgedByWeights(const Material& material) {
    return material.type == MaterialType::BlinnPhong && !material.normalize &&
           material.colorTexture == Material::kNoTexture;
}

std::optional<double> excessAlbedo(const Material& material, TextureRanges& textures) {
    switch (material.type) {
    case MaterialType::BlinnPhong:
        return whereAbove(1.0 + kRounding, blinnPhongAlbedo(material, textures));
    case MaterialType::Nonmetal:
        return whereAbove(1.0 + kTolerance, nonmetalAlbedo(material, textures));
    case MaterialType::Diffuse:
    case MaterialType::Metal:
    case MaterialType::Dielectric:
        break;
    }
    return std::nullopt;
}

} // namespace calotype
