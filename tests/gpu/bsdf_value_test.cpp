// The value and density of every opaque material against the equations of docs/models.md in double
// precision, and against what holds for any reflection.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "kernels/scattering.spv.h"
#include "support/gpu_test.h"
#include "support/oracle_bsdf.h"
#include "support/random_numbers.h"
#include "support/test_materials.h"

namespace calotype::test {
namespace {

class BsdfValueTest : public GpuTest {};

/// Pairs of directions where the lobe is: half vectors spread over a few of its widths.
std::vector<shared::TestScattering> eventsAcross(const TestMaterial& test, int count,
                                                 RandomNumbers& random) {
    std::vector<shared::TestScattering> events;
    while (events.size() < static_cast<size_t>(count)) {
        const glm::dvec3 wo = directionAt(random.between(0.03, 1.0), random.between(0.0, 6.28));
        const double tangent = test.lobeWidth * random.between(0.0, 4.0);
        const glm::dvec3 h =
            directionAt(1.0 / std::sqrt(1.0 + tangent * tangent), random.between(0.0, 6.28));
        const glm::dvec3 wi = 2.0 * glm::dot(wo, h) * h - wo;
        if (glm::dot(wo, h) <= 0.02 || wi.z <= 0.02)
            continue;
        events.push_back(scatteringOn(test.material, wo));
        events.back().wi = glm::vec3(wi);
    }
    return events;
}

/// In double, and unit again after rounding to float.
glm::dvec3 unit(const glm::vec3& v) { return glm::normalize(glm::dvec3(v)); }

/// Rounding of the two directions turns the half vector by about this angle, which a lobe of some
/// width feels as that much over its width, times the four powers of the steepest factor.
double relativeTolerance(const TestMaterial& test, const glm::dvec3& wo, const glm::dvec3& wi) {
    constexpr double kTurn = 4e-7;
    return 1e-5 + 16.0 * kTurn / (test.lobeWidth * glm::length(wo + wi));
}

TEST_F(BsdfValueTest, IsTheModelsEquation) {
    RandomNumbers random(71);
    for (const TestMaterial& test : testMaterials()) {
        const auto events = eventsAcross(test, 4000, random);
        const auto results = runKernel<shared::TestScattered>(kScatteringSpirv, events);
        for (size_t i = 0; i < events.size(); ++i) {
            const glm::dvec3 wo = unit(events[i].wo);
            const glm::dvec3 wi = unit(events[i].wi);
            const glm::dvec3 wanted = oracleValue(test.material, wo, wi);
            const double tolerance = relativeTolerance(test, wo, wi);
            for (int channel = 0; channel < 3; ++channel)
                ASSERT_NEAR(results[i].given[channel], wanted[channel],
                            tolerance * wanted[channel] + 1e-12)
                    << test.name << ", cosines " << wo.z << " " << wi.z;
        }
    }
}

TEST_F(BsdfValueTest, DensityIsThatOfTheWholeMixture) {
    RandomNumbers random(72);
    for (const TestMaterial& test : testMaterials()) {
        const auto events = eventsAcross(test, 4000, random);
        const auto results = runKernel<shared::TestScattered>(kScatteringSpirv, events);
        for (size_t i = 0; i < events.size(); ++i) {
            const glm::dvec3 wo = unit(events[i].wo);
            const glm::dvec3 wi = unit(events[i].wi);
            const double chance = results[i].diffuseProbability;
            const double halfVector =
                chance < 1.0 ? oracleHalfVectorPdf(test.material, wo, wi) : 0.0;
            const double wanted = chance * wi.z / std::numbers::pi + (1.0 - chance) * halfVector;
            ASSERT_NEAR(results[i].givenPdf, wanted,
                        relativeTolerance(test, wo, wi) * wanted + 1e-12)
                << test.name << ", cosines " << wo.z << " " << wi.z;
        }
    }
}

TEST_F(BsdfValueTest, IsTheSameBothWays) {
    RandomNumbers random(73);
    for (const TestMaterial& test : testMaterials()) {
        const auto events = eventsAcross(test, 2000, random);
        auto reversed = events;
        for (shared::TestScattering& event : reversed)
            std::swap(event.wo, event.wi);
        const auto there = runKernel<shared::TestScattered>(kScatteringSpirv, events);
        const auto back = runKernel<shared::TestScattered>(kScatteringSpirv, reversed);
        for (size_t i = 0; i < events.size(); ++i) {
            const double f = there[i].given.x / events[i].wi.z;
            const double g = back[i].given.x / events[i].wo.z;
            ASSERT_NEAR(f, g, 1e-4 * f + 1e-12) << test.name;
        }
    }
}

// Nothing on the far side, and nothing is not a number where both directions graze.
TEST_F(BsdfValueTest, IsZeroBelowTheSurfaceAndFiniteAtItsEdge) {
    RandomNumbers random(74);
    for (const TestMaterial& test : testMaterials()) {
        std::vector<shared::TestScattering> events;
        for (const double cosO : {1e-7, 1e-4, 0.5, 1.0})
            for (const double cosI : {-1.0, -1e-3, -1e-7, 1e-7, 1e-4, 1.0})
                for (const double phi : {0.0, 1.0, std::numbers::pi}) {
                    events.push_back(scatteringOn(test.material, directionAt(cosO, 0.0)));
                    events.back().wi = glm::vec3(directionAt(std::abs(cosI), phi));
                    events.back().wi.z = static_cast<float>(cosI);
                    events.back().u1 = random.deviceUnit();
                }
        const auto results = runKernel<shared::TestScattered>(kScatteringSpirv, events);
        for (size_t i = 0; i < events.size(); ++i) {
            const shared::TestScattered& r = results[i];
            ASSERT_TRUE(std::isfinite(r.given.x + r.given.y + r.given.z + r.givenPdf)) << test.name;
            ASSERT_TRUE(std::isfinite(r.weight.x + r.weight.y + r.weight.z + r.pdf)) << test.name;
            ASSERT_GE(std::min({r.given.x, r.given.y, r.given.z, r.givenPdf}), 0.0f) << test.name;
            if (events[i].wi.z < 0.0f)
                ASSERT_EQ(r.given, glm::vec3(0.0f)) << test.name;
        }
    }
}

} // namespace
} // namespace calotype::test
