// Directions drawn from every opaque material: distributed as their density says, weighted by value
// over density, and conserving energy where the scene format says so.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "kernels/scattering.spv.h"
#include "support/direction_fit.h"
#include "support/gpu_test.h"
#include "support/oracle_bsdf.h"
#include "support/random_numbers.h"
#include "support/slow_run.h"
#include "support/statistics.h"
#include "support/test_materials.h"

namespace calotype::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kCosines[] = {1.0, 0.7, 0.25, 0.04};

/// The viewer's place, off the axes of the frame.
glm::dvec3 viewer(double cosTheta) { return directionAt(cosTheta, 0.8); }

/// What a material makes of random numbers, seen from one side.
struct View {
    double cosThetaO;
    std::vector<shared::TestScattered> samples;
};

/// From each cosine, by one run of the kernel. A quarter of the samples, as in the quick run, shows
/// twice the error of a density or an albedo.
std::vector<View> drawSamples(const TestMaterial& test, RandomNumbers& random) {
    const uint32_t count = quickOrFull(15'000, 60'000);
    std::vector<shared::TestScattering> events;
    for (const double cosThetaO : kCosines) {
        const size_t first = events.size();
        events.resize(first + count, scatteringOn(test.material, viewer(cosThetaO)));
        for (size_t i = 0; i < count; ++i) {
            shared::TestScattering& event = events[first + i];
            event.u1 = random.deviceUnit();
            event.u2 = random.deviceUnit();
            event.u3 = random.deviceUnit();
            if (i < 8) { // the ends of the numbers' range
                const auto end = [](bool upper) { return upper ? 1.0f - 0x1p-24f : 0.0f; };
                event.u1 = end(i & 1);
                event.u2 = end(i & 2);
                event.u3 = end(i & 4);
            }
        }
    }
    const auto samples = runKernel<shared::TestScattered>(kScatteringSpirv, events);
    std::vector<View> views;
    for (auto at = samples.begin(); at != samples.end(); at += count)
        views.push_back({kCosines[views.size()], {at, at + count}});
    return views;
}

double mixturePdf(const TestMaterial& test, double diffuseProbability, const glm::dvec3& wo,
                  const glm::dvec3& wi) {
    const double halfVector =
        diffuseProbability < 1.0 ? oracleHalfVectorPdf(test.material, wo, wi) : 0.0;
    return diffuseProbability * wi.z / kPi + (1.0 - diffuseProbability) * halfVector;
}

class BsdfSampleTest : public GpuTest {};

TEST_F(BsdfSampleTest, IsDistributedAsItsDensity) {
    RandomNumbers random(81);
    for (const TestMaterial& test : testMaterials())
        for (const auto& [cosThetaO, samples] : drawSamples(test, random)) {
            const glm::dvec3 wo = viewer(cosThetaO);
            const double diffuseProbability = samples[0].diffuseProbability;
            std::vector<glm::dvec3> directions;
            for (const shared::TestScattered& sample : samples)
                if (sample.pdf > 0.0f)
                    directions.emplace_back(sample.wi);
            const DirectionFit fit = fitDirections(
                directions, samples.size(), wo, test.lobeWidth,
                [&](const glm::dvec3& wi) { return mixturePdf(test, diffuseProbability, wo, wi); });
            // The density integrates to one, but for what falls below the surface.
            EXPECT_NEAR(fit.integral, fit.accepted, fit.tolerance)
                << test.name << ", cosine " << cosThetaO;
            EXPECT_LT(fit.chiSquare, fit.limit) << test.name << ", cosine " << cosThetaO;
        }
}
ALSO_SLOW(BsdfSampleTest, IsDistributedAsItsDensity);

TEST_F(BsdfSampleTest, WeighsValueOverDensity) {
    RandomNumbers random(82);
    for (const TestMaterial& test : testMaterials())
        for (const auto& [cosThetaO, samples] : drawSamples(test, random)) {
            const glm::dvec3 wo = viewer(cosThetaO);
            for (const shared::TestScattered& sample : samples) {
                ASSERT_TRUE(std::isfinite(sample.weight.x + sample.pdf)) << test.name;
                const glm::dvec3 wi = glm::normalize(glm::dvec3(sample.wi));
                if (sample.pdf == 0.0f || wi.z < 1e-3)
                    continue;
                ASSERT_EQ(sample.pdf, sample.pdfAgain);
                const glm::dvec3 value = oracleValue(test.material, wo, wi);
                const double pdf = mixturePdf(test, sample.diffuseProbability, wo, wi);
                // Rounding turns the half vector, and the shares of two lobes with it.
                const double tolerance =
                    1e-4 + 2e-5 / (test.lobeWidth * glm::length(wo + wi)) + 1e-6 / wi.z;
                ASSERT_NEAR(sample.weight.x, value.x / pdf, tolerance * value.x / pdf)
                    << test.name << ", cosines " << cosThetaO << " " << wi.z;
            }
        }
}
ALSO_SLOW(BsdfSampleTest, WeighsValueOverDensity);

// Blinn-Phong that is not normalized reflects up to about 4 ks; every other model at most what
// arrives.
TEST_F(BsdfSampleTest, ConservesEnergyWhereItShould) {
    RandomNumbers random(83);
    for (TestMaterial test : testMaterials()) {
        if (test.material.type == MaterialType::Metal)
            test.material.color = glm::dvec3(1.0);
        for (const auto& [cosThetaO, samples] : drawSamples(test, random)) {
            std::vector<double> weights;
            for (const shared::TestScattered& sample : samples)
                weights.push_back(sample.weight.x);
            const Estimate albedo = estimate(weights);
            if (test.conservesEnergy) {
                EXPECT_LT(albedo.mean, 1.0 + 4.0 * albedo.standardError + 1e-6)
                    << test.name << ", cosine " << cosThetaO;
            }
            if (test.material.type == MaterialType::BlinnPhong && test.material.kd == 0.0 &&
                !test.material.normalize && cosThetaO == 1.0 && test.material.exponent > 10.0) {
                EXPECT_GT(albedo.mean, 3.3 * test.material.ks) << test.name;
            }
        }
    }
}
ALSO_SLOW(BsdfSampleTest, ConservesEnergyWhereItShould);

} // namespace
} // namespace calotype::test
