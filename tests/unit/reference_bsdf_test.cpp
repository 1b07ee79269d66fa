// The reference tracer's materials against equations that were written separately, and against what
// holds for any material.
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "reference/bsdf.h"
#include "reference/ggx_lobe.h"
#include "support/direction_fit.h"
#include "support/oracle_bsdf.h"
#include "support/random_numbers.h"
#include "support/slow_run.h"
#include "support/statistics.h"
#include "support/test_materials.h"

namespace calotype::test {
namespace {

using reference::Bsdf;
using reference::GgxLobe;

constexpr double kCosines[] = {1.0, 0.7, 0.25, 0.04};

/// On a plane with normal z, whose frame is the world's.
Bsdf bsdfOf(const Material& material, const glm::dvec3& wo) {
    reference::Surface surface{};
    surface.ng = surface.ns = surface.horizon = {0.0, 0.0, 1.0};
    return {material, {}, surface, wo};
}

glm::dvec3 viewer(double cosTheta) { return directionAt(cosTheta, 0.8); }

glm::dvec3 someNumbers(RandomNumbers& random) {
    return {random.unit(), random.unit(), random.unit()};
}

/// Shows each material from each of the cosines.
template <typename Check>
void forEachView(const Check& check) {
    for (const TestMaterial& test : testMaterials())
        for (const double cosThetaO : kCosines) {
            SCOPED_TRACE(test.name + ", cosine " + std::to_string(cosThetaO));
            check(test, viewer(cosThetaO));
        }
}

TEST(ReferenceBsdfTest, HasTheModelsValues) {
    RandomNumbers random(201);
    forEachView([&](const TestMaterial& test, const glm::dvec3& wo) {
        const Bsdf bsdf = bsdfOf(test.material, wo);
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 wi = directionAt(random.powerOfTen(-3.0, 0.0), 6.0 * random.unit());
            const glm::dvec3 expected = oracleValue(test.material, wo, wi);
            const glm::dvec3 seen = bsdf.evaluate(wi).value;
            for (int channel = 0; channel < 3; ++channel)
                ASSERT_NEAR(seen[channel], expected[channel], 1e-9 * expected[channel] + 1e-300);
        }
    });
}

TEST(ReferenceBsdfTest, IsReciprocal) {
    RandomNumbers random(202);
    forEachView([&](const TestMaterial& test, const glm::dvec3& wo) {
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 wi = directionAt(random.powerOfTen(-3.0, 0.0), 6.0 * random.unit());
            const double there = bsdfOf(test.material, wo).evaluate(wi).value.x / wi.z;
            const double back = bsdfOf(test.material, wi).evaluate(wo).value.x / wo.z;
            ASSERT_NEAR(there, back, 1e-9 * back + 1e-300);
        }
    });
}

// A quarter of the samples shows twice the error of a density.
TEST(ReferenceBsdfTest, DrawsDirectionsAsItsDensitySays) {
    const size_t count = quickOrFull(15'000, 60'000);
    RandomNumbers random(203);
    forEachView([&](const TestMaterial& test, const glm::dvec3& wo) {
        const Bsdf bsdf = bsdfOf(test.material, wo);
        std::vector<glm::dvec3> directions;
        for (size_t i = 0; i < count; ++i) {
            const Bsdf::Sample sample = bsdf.sample(someNumbers(random));
            if (sample.pdf == 0.0)
                continue;
            directions.push_back(sample.wi);
            const Bsdf::Value value = bsdf.evaluate(sample.wi);
            ASSERT_EQ(sample.pdf, value.pdf);
            ASSERT_EQ(sample.weight, value.value / value.pdf);
        }
        const DirectionFit fit =
            fitDirections(directions, count, wo, test.lobeWidth,
                          [&](const glm::dvec3& wi) { return bsdf.evaluate(wi).pdf; });
        EXPECT_NEAR(fit.integral, fit.accepted, fit.tolerance);
        EXPECT_LT(fit.chiSquare, fit.limit);
    });
}
ALSO_SLOW_TEST(ReferenceBsdfTest, DrawsDirectionsAsItsDensitySays);

TEST(ReferenceBsdfTest, ConservesEnergyWhereItShould) {
    RandomNumbers random(204);
    forEachView([&](TestMaterial test, const glm::dvec3& wo) {
        if (!test.conservesEnergy)
            return;
        if (test.material.type == MaterialType::Metal)
            test.material.color = glm::dvec3(1.0);
        const Bsdf bsdf = bsdfOf(test.material, wo);
        std::vector<double> weights;
        for (int i = 0; i < 20'000; ++i)
            weights.push_back(bsdf.sample(someNumbers(random)).weight.x);
        const Estimate albedo = estimate(weights);
        EXPECT_LT(albedo.mean, 1.0 + 4.0 * albedo.standardError + 1e-9);
    });
}

// On both sides of the threshold below which a metal is a mirror, it reflects as much.
TEST(ReferenceBsdfTest, BecomesAMirrorContinuously) {
    RandomNumbers random(205);
    for (const Masking masking : {Masking::Schlick, Masking::Smith})
        for (const double cosThetaO : kCosines) {
            Material metal;
            metal.type = MaterialType::Metal;
            metal.color = {0.9, 0.6, 0.3};
            metal.masking = masking;
            const auto albedo = [&](double alpha) {
                metal.roughness = std::sqrt(alpha);
                const Bsdf bsdf = bsdfOf(metal, viewer(cosThetaO));
                EXPECT_EQ(bsdf.isSpecular(), alpha < GgxLobe::kMirrorAlpha);
                std::vector<double> weights;
                for (int i = 0; i < 2000; ++i)
                    weights.push_back(bsdf.sample(someNumbers(random)).weight.y);
                return estimate(weights).mean;
            };
            const double mirror = albedo(0.999 * GgxLobe::kMirrorAlpha);
            EXPECT_NEAR(albedo(1.001 * GgxLobe::kMirrorAlpha), mirror, 1e-3 * mirror) << cosThetaO;
        }
}

Bsdf boundaryOf(double ior, const glm::dvec3& wo) {
    Material glass;
    glass.type = MaterialType::Dielectric;
    glass.color = glm::dvec3(1.0);
    glass.ior = ior;
    return bsdfOf(glass, wo);
}

/// The least number for which the boundary lets light through.
double reflectedShare(const Bsdf& boundary) {
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (boundary.sample({0.0, 0.0, middle}).crosses ? high : low) = middle;
    }
    return high;
}

TEST(ReferenceBsdfTest, ReflectsByFresnelsEquations) {
    for (const double ior : {1.0 / 1.5, 1.000001, 1.33, 1.5, 4.0})
        for (const double cosTheta : {1.0, 0.9, 0.76, 0.5, 0.1, 0.001})
            for (const double side : {1.0, -1.0}) {
                const glm::dvec3 wo = side * viewer(cosTheta);
                const double eta = side > 0.0 ? ior : 1.0 / ior;
                EXPECT_NEAR(reflectedShare(boundaryOf(ior, wo)), oracleFresnel(cosTheta, eta), 1e-9)
                    << ior << " " << cosTheta << " " << side;
            }
}

TEST(ReferenceBsdfTest, RefractsBySnellsLaw) {
    for (const double ior : {1.0 / 1.5, 1.33, 4.0})
        for (const double cosTheta : {1.0, 0.9, 0.8})
            for (const double side : {1.0, -1.0}) {
                const glm::dvec3 wo = side * viewer(cosTheta);
                const double eta = side > 0.0 ? ior : 1.0 / ior;
                if (std::sqrt(1.0 - cosTheta * cosTheta) >= eta)
                    continue; // total reflection
                const Bsdf boundary = boundaryOf(ior, wo);
                const Bsdf::Sample through = boundary.sample({0.0, 0.0, 1.0 - 0x1p-24});
                ASSERT_TRUE(through.crosses);
                EXPECT_LT(side * through.wi.z, 0.0);
                EXPECT_NEAR(glm::length(through.wi), 1.0, 1e-12);
                // The sines are as the indices, in the plane of incidence.
                EXPECT_NEAR(eta * through.wi.x, -wo.x, 1e-12);
                EXPECT_NEAR(eta * through.wi.y, -wo.y, 1e-12);
                EXPECT_NEAR(through.weight.x, 1.0 / (eta * eta), 1e-12);
                const Bsdf::Sample back = boundary.sample({0.0, 0.0, 0.0});
                if (back.crosses)
                    continue;
                EXPECT_NEAR(glm::distance(back.wi, {-wo.x, -wo.y, wo.z}), 0.0, 1e-12);
                EXPECT_EQ(back.weight, glm::dvec3(1.0));
            }
}

} // namespace
} // namespace calotype::test
