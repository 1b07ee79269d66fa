// The reference tracer's lights against irradiances known in closed form, and against rays that
// look for the light everywhere.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "reference/lights.h"
#include "reference/spherical_triangle.h"
#include "reference/warp.h"
#include "support/random_numbers.h"
#include "support/statistics.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

using reference::Geometry;
using reference::Light;
using reference::Lights;

constexpr double kPi = std::numbers::pi;

/// Lights with the geometry that they refer to.
struct LitScene {
    explicit LitScene(std::vector<Shape> shapes, const glm::dvec3& background = glm::dvec3(0.0))
        : scene(sceneOf(std::move(shapes))), geometry(scene), lights(prepared(background)) {}

    Scene scene;
    Geometry geometry;
    Lights lights;

private:
    Lights prepared(const glm::dvec3& background) {
        scene.background = background;
        for (Material& material : scene.materials)
            material.emission = glm::dvec3(1.0);
        return {scene, geometry};
    }
};

/// Of a plane through the origin with normal +y, by points that the first light's sampling chose.
Estimate irradianceBySampling(const LitScene& lit, uint32_t primitive) {
    RandomNumbers random(211);
    std::vector<double> values;
    for (int i = 0; i < 200'000; ++i) {
        const Light::Sample sample =
            lit.lights.ofPrimitive(primitive)->sample({}, {random.unit(), random.unit()});
        const double cosTheta = sample.wi.y;
        values.push_back(sample.pdf > 0.0 ? std::max(cosTheta, 0.0) / sample.pdf : 0.0);
    }
    return estimate(values);
}

/// Likewise, by rays in all directions of the upper hemisphere; and the mean of the light's density
/// over those that meet it, times 2 pi: the integral of that density.
struct ByRays {
    Estimate irradiance;
    Estimate integralOfPdf;
};
ByRays lookEverywhere(const LitScene& lit, uint32_t primitive) {
    RandomNumbers random(212);
    std::vector<double> values;
    std::vector<double> densities;
    for (int i = 0; i < 200'000; ++i) {
        glm::dvec3 w = random.direction();
        w.y = std::abs(w.y);
        const reference::Ray ray{{}, w};
        const auto hit = lit.geometry.closest(ray);
        if (!hit) {
            values.push_back(0.0);
            densities.push_back(0.0);
            continue;
        }
        const reference::Surface surface = lit.geometry.surface(*hit, ray);
        values.push_back(2.0 * kPi * w.y);
        densities.push_back(
            2.0 * kPi *
            lit.lights.ofPrimitive(primitive)->pdf({}, w, {surface.position, surface.ng}));
    }
    return {estimate(values), estimate(densities)};
}

void expectNear(const Estimate& seen, double expected) {
    EXPECT_NEAR(seen.mean, expected, 4.0 * seen.standardError + 1e-9 * expected);
    EXPECT_LT(seen.standardError, 0.02 * expected);
}

RigidTransform at(const glm::dvec3& place) { return {glm::dmat3(1.0), place}; }

TEST(ReferenceLightsTest, SphereLightsAsItsSolidAngleSays) {
    const LitScene lit({shapeOf(Sphere{at({0.0, 3.0, 0.0}), 1.0})});
    expectNear(irradianceBySampling(lit, 0), kPi / 9.0);
}

// (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-12.)
TEST(ReferenceLightsTest, DiskLightsAsItsAngleSays) {
    const LitScene lit({shapeOf(Disk{at({0.0, 2.0, 0.0}), 1.5})});
    expectNear(irradianceBySampling(lit, 0), kPi * 2.25 / (2.25 + 4.0));
}

/// Irradiance from a triangle of radiance 1: half the sum of the edges' angles, each times the
/// cosine of its plane (Lambert 1760).
double lambertsFormula(const glm::dvec3 (&corners)[3]) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3& a = corners[i];
        const glm::dvec3& b = corners[(i + 1) % 3];
        sum += 0.5 * std::acos(glm::dot(glm::normalize(a), glm::normalize(b))) *
               glm::normalize(glm::cross(a, b)).y;
    }
    return std::abs(sum);
}

reference::SeenTriangle seenFromOrigin(const glm::dvec3 (&corners)[3]) {
    return {corners[0], corners[1], corners[2]};
}

TEST(ReferenceLightsTest, TriangleLightsByLambertsFormula) {
    const glm::dvec3 corners[] = {{-0.5, 1.0, 0.3}, {1.2, 1.5, 0.1}, {0.2, 2.0, -1.0}};
    const LitScene lit({shapeOf(singleTriangle(corners[0], corners[1], corners[2]))});
    expectNear(irradianceBySampling(lit, 0), lambertsFormula(corners));
}

// (Lambert 1760, as above.) By solid angle no value exceeds the solid angle, however near the lamp
// is: here its height is a fiftieth of its size.
TEST(ReferenceLightsTest, NearTriangleLightsWithLittleVariance) {
    const glm::dvec3 corners[] = {{-0.8, 0.02, 0.6}, {1.1, 0.02, 0.5}, {0.1, 0.02, -1.3}};
    const LitScene lit({shapeOf(singleTriangle(corners[0], corners[1], corners[2]))});
    const Estimate sampled = irradianceBySampling(lit, 0);
    const double expected = lambertsFormula(corners);
    expectNear(sampled, expected);
    // Of a value of the mean m that is at most s, the variance is at most m (s - m).
    const double most = seenFromOrigin(corners).solidAngle();
    EXPECT_LT(sampled.standardError, std::sqrt(expected * (most - expected) / 200'000.0) * 1.01);
}

TEST(ReferenceLightsTest, SampledAndSeenAreTheSameLight) {
    const Shape kinds[] = {shapeOf(Sphere{at({0.5, 2.0, 0.2}), 0.7}),
                           shapeOf(Cylinder{at({0.5, 2.0, 0.2}), 0.7, 1.5}),
                           shapeOf(Cone{at({0.5, 3.0, 0.2}), -1.5, 0.6}),
                           shapeOf(Disk{at({0.5, 2.0, 0.2}), 0.7}),
                           shapeOf(singleTriangle({0, 1, 0}, {1, 2, 0}, {0, 2, 1})),
                           shapeOf(Sphere{at({0.0, 0.5, 0.0}), 2.0}),        // from inside
                           shapeOf(Cylinder{at({0.2, 0.5, 0.0}), 2.0, 3.0}), // likewise
                           shapeOf(Cone{at({0.2, 3.0, 0.0}), -5.0, 1.0})};   // likewise
    for (const Shape& shape : kinds) {
        SCOPED_TRACE(shape.geometry.index());
        const LitScene lit({shape});
        const Estimate sampled = irradianceBySampling(lit, 0);
        const Estimate seen = lookEverywhere(lit, 0).irradiance;
        EXPECT_NEAR(sampled.mean, seen.mean,
                    4.0 * std::hypot(sampled.standardError, seen.standardError));
        EXPECT_GT(seen.mean, 0.05);
    }
}

// What is seen under all of its density integrates to one; of a solid sampled by area, to the share
// of it that faces here.
TEST(ReferenceLightsTest, DensityIntegratesToWhatIsSeen) {
    for (const Shape& shape :
         {shapeOf(Sphere{at({0.5, 2.0, 0.2}), 0.7}), shapeOf(Disk{at({0.5, 2.0, 0.2}), 0.7}),
          shapeOf(singleTriangle({0, 1, 0}, {1, 2, 0}, {0, 2, 1})),
          shapeOf(singleTriangle({-0.8, 0.02, 0.6}, {1.1, 0.02, 0.5}, {0.1, 0.02, -1.3}))})
        expectNear(lookEverywhere(LitScene({shape}), 0).integralOfPdf, 1.0);
    // From far on its axis a cylinder shows one cap of its area.
    const LitScene lit({shapeOf(Cylinder{at({0.0, 6.0, 0.0}), 1.0, 2.0})});
    expectNear(lookEverywhere(lit, 0).integralOfPdf, kPi / (6.0 * kPi));
}

TEST(ReferenceLightsTest, AreChosenByTheirPower) {
    LitScene lit({shapeOf(Sphere{at({0, 2, 0}), 0.5}), shapeOf(Disk{at({3, 2, 0}), 1.0}),
                  shapeOf(Sphere{at({0, 9, 0}), 0.1})},
                 glm::dvec3(1e-4));
    // Both shine from both sides; a background this faint sends less than all others.
    const double areas[] = {kPi, kPi, 0.04 * kPi};
    const Bounds3d bounds = [] {
        Bounds3d all;
        all.extend({-0.5, 1.5, -1.0});
        all.extend({4.0, 9.1, 1.0});
        return all;
    }();
    const double background = 1e-4 * kPi * glm::dot(bounds.extent(), bounds.extent());
    const double sum = 2.0 * (areas[0] + areas[1] + areas[2]) + background;
    constexpr int kNumbers = 1 << 24;
    std::vector<int> counts(4);
    std::vector<double> places(4);
    for (int i = 0; i < kNumbers; ++i) {
        const Lights::Choice choice =
            lit.lights.choose({glm::dvec3(0.0)}, {double(i) / kNumbers, 0.5});
        const uint32_t index = choice.light.primitive().value_or(3);
        ++counts[index];
        places[index] += choice.u;
    }
    for (uint32_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(lit.lights.ofPrimitive(i)->selectionProbability, 2.0 * areas[i] / sum, 1e-6);
        EXPECT_EQ(lit.lights.ofPrimitive(i)->selectionProbability, double(counts[i]) / kNumbers);
    }
    EXPECT_NEAR(lit.lights.infinite()->selectionProbability, background / sum, 1e-6);
    EXPECT_EQ(lit.lights.infinite()->selectionProbability, double(counts[3]) / kNumbers);
    for (uint32_t i = 0; i < 4; ++i)
        EXPECT_NEAR(places[i] / counts[i], 0.5, 1e-9);
}

} // namespace
} // namespace calotype::test
