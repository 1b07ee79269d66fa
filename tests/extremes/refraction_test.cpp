// Fresnel and Snell at extreme indices of refraction, from the normal to the surface's plane and on
// both sides of the critical angle, against double.
#include <algorithm>
#include <cmath>
#include <iostream>

#include <glm/geometric.hpp>

#include "kernels/refraction.spv.h"
#include "kernels/scattering.spv.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/oracle_bsdf.h"
#include "support/random_numbers.h"
#include "support/test_materials.h"

namespace calotype::test {
namespace {

constexpr double kEtas[] = {0.01, 0.25, 1.0 / 1.5,      1.0 - 1e-6, 1.0,  1.0 + 1e-6,
                            1.01, 1.5,  1.0 / (1.0001), 4.0,        100.0};

/// Cosines of all magnitudes, and as near to the critical angle as floats go.
std::vector<float> cosinesFor(double eta, RandomNumbers& random) {
    std::vector<float> cosines = {1.0f, 1.0f - 0x1p-24f, 1e-6f};
    const double critical = eta < 1.0 ? std::sqrt((1.0 - eta) * (1.0 + eta)) : 0.0;
    for (int i = 0; i < 4000; ++i) {
        const double beside = critical * (1.0 + random.sign() * random.powerOfTen(-8.0, -1.0));
        const double anywhere = random.coin() ? random.unit() : random.powerOfTen(-6.0, 0.0);
        cosines.push_back(static_cast<float>(
            std::clamp(eta < 1.0 && random.coin() ? beside : anywhere, 1e-6, 1.0)));
    }
    return cosines;
}

/// Snell's law: of the refracted direction, 0 where there is none.
double refractedCosine(double cosThetaI, double eta) {
    const double sin2 = (1.0 - cosThetaI) * (1.0 + cosThetaI) / (eta * eta);
    return sin2 < 1.0 ? std::sqrt(1.0 - sin2) : 0.0;
}

class RefractionExtremesTest : public GpuTest {};

// Right are the answers of a cosine and an index that are off by eight roundings at most. About the
// critical angle both are as steep as a square root.
TEST_F(RefractionExtremesTest, AreThoseOfAnIndexWithinRounding) {
    constexpr double kSlack = 8.0 * kRoundoffOfFloat;
    RandomNumbers random(221);
    double worst = 0.0;
    for (const double eta : kEtas) {
        std::vector<glm::vec4> queries; // sine, cosine, index of refraction
        for (const float cosine : cosinesFor(eta, random))
            queries.emplace_back(std::sqrt((1.0 - cosine) * (1.0 + cosine)), cosine, eta, 0.0);
        const auto answers = runKernel<glm::vec2>(kRefractionSpirv, queries);
        for (size_t i = 0; i < queries.size(); ++i) {
            const double cosine = queries[i].y;
            const double exactEta = queries[i].z;
            double lower[2] = {1.0, 1.0};
            double upper[2] = {0.0, 0.0};
            for (const double c : {1.0 - kSlack, 1.0, 1.0 + kSlack})
                for (const double e : {1.0 - kSlack, 1.0, 1.0 + kSlack}) {
                    const double near[2] = {
                        oracleFresnel(std::min(1.0, c * cosine), e * exactEta),
                        refractedCosine(std::min(1.0, c * cosine), e * exactEta)};
                    for (int k = 0; k < 2; ++k) {
                        lower[k] = std::min(lower[k], near[k]);
                        upper[k] = std::max(upper[k], near[k]);
                    }
                }
            for (int k = 0; k < 2; ++k) {
                ASSERT_GE(answers[i][k], lower[k] - kSlack) << "eta " << eta << " at " << cosine;
                ASSERT_LE(answers[i][k], upper[k] + kSlack) << "eta " << eta << " at " << cosine;
            }
            ASSERT_TRUE(answers[i].x >= 0.0f && answers[i].x <= 1.0f);
            worst = std::max(worst, std::abs(answers[i].x - oracleFresnel(cosine, exactEta)));
        }
    }
    std::cout << "reflectance off by " << worst << " at most\n";
}

// Whatever the index, light that crosses follows Snell's law and stays on its side, and what
// crosses twice comes back with its weight.
TEST_F(RefractionExtremesTest, DirectionsAreSnells) {
    RandomNumbers random(222);
    Material glass;
    glass.type = MaterialType::Dielectric;
    glass.color = glm::dvec3(1.0);
    double worstSine = 0.0;
    double worstLength = 0.0;
    for (const double eta : kEtas) {
        glass.ior = eta;
        std::vector<shared::TestScattering> events;
        for (const float cosine : cosinesFor(eta, random))
            for (const float u : {0.0f, 1.0f - 0x1p-24f, random.deviceUnit()}) {
                events.push_back(scatteringOn(glass, directionAt(cosine, 6.28 * random.unit())));
                events.back().u3 = u;
            }
        const auto answers = runKernel<shared::TestScattered>(kScatteringSpirv, events);
        for (size_t i = 0; i < events.size(); ++i) {
            const glm::dvec3 wo(events[i].wo);
            const glm::dvec3 wi(answers[i].wi);
            const bool crosses = answers[i].crosses != 0;
            const double ratio = crosses ? double(events[i].material.eta) : 1.0;
            ASSERT_TRUE(std::isfinite(wi.x + wi.y + wi.z));
            ASSERT_TRUE(crosses ? wi.z <= 0.0 : wi.z >= 0.0);
            ASSERT_NEAR(answers[i].weight.x * ratio * ratio, 1.0, 4.0 * kRoundoffOfFloat);
            const double sine = std::hypot(wi.x * ratio + wo.x, wi.y * ratio + wo.y) / ratio;
            worstSine = std::max(worstSine, sine);
            worstLength = std::max(worstLength, std::abs(glm::length(wi) - 1.0));
        }
    }
    std::cout << "directions off by " << worstSine << ", lengths by " << worstLength << "\n";
    EXPECT_LE(worstSine, 4.0 * kRoundoffOfFloat);
    EXPECT_LE(worstLength, 8.0 * kRoundoffOfFloat);
}

} // namespace
} // namespace calotype::test
