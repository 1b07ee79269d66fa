// The albedo that energy warnings go by.

#include <cmath>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "scene/material_energy.h"

namespace calotype {
namespace {

TEST(MaterialEnergy, AlbedoOfAMirrorIsFresnelTimesMasking) {
    // k is 1/8 at roughness 0.
    for (const double cosine : {0.05, 0.3, 0.8, 1.0}) {
        const double fresnel = 0.04 + 0.96 * std::pow(1.0 - cosine, 5.0);
        const double g1 = cosine / (cosine * 0.875 + 0.125);
        EXPECT_NEAR(ggxAlbedo(cosine, 0.0, 0.04, Masking::Schlick), fresnel * g1 * g1, 1e-12);
        EXPECT_NEAR(ggxAlbedo(cosine, 0.0, 0.04, Masking::Smith), fresnel, 1e-12);
    }
}

/// The same integral over directions of light on a fine grid, by the equations as they are written
/// (1.27 to 1.30).
double slowAlbedo(double cosine, double roughness, double f0) {
    constexpr int kSteps = 1500;
    const double alpha2 = std::pow(roughness, 4.0);
    const double k = std::pow(roughness + 1.0, 2.0) / 8.0;
    const glm::dvec3 v(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double z = (i + 0.5) / kSteps;
        for (int j = 0; j < kSteps; ++j) {
            const double azimuth = M_PI * (j + 0.5) / kSteps;
            const double r = std::sqrt(1.0 - z * z);
            const glm::dvec3 l(r * std::cos(azimuth), r * std::sin(azimuth), z);
            const glm::dvec3 h = (v + l) / std::sqrt(2.0 + 2.0 * (v.x * l.x + v.z * l.z));
            const double d = alpha2 / (M_PI * std::pow(h.z * h.z * (alpha2 - 1.0) + 1.0, 2.0));
            const double f = f0 + (1.0 - f0) * std::pow(1.0 - (v.x * h.x + v.z * h.z), 5.0);
            const double g = z / (z * (1.0 - k) + k) * cosine / (cosine * (1.0 - k) + k);
            sum += d * f * g / (4.0 * z * cosine) * z;
        }
    }
    return sum * 2.0 * M_PI / (double(kSteps) * kSteps);
}

TEST(MaterialEnergy, AlbedoAgreesWithTheEquationsIntegratedOverTheHemisphere) {
    for (const double roughness : {0.4, 0.7, 1.0}) {
        for (const double cosine : {0.1, 0.4, 0.9}) {
            EXPECT_NEAR(ggxAlbedo(cosine, roughness, 0.04, Masking::Schlick),
                        slowAlbedo(cosine, roughness, 0.04), 0.001)
                << roughness << " " << cosine;
        }
    }
}

} // namespace
} // namespace calotype
