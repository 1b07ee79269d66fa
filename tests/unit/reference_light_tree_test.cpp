// The choice of lights through a tree, in the reference tracer.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "reference/lights.h"
#include "reference/tree_choice.h"
#include "support/chi_square.h"
#include "support/random_numbers.h"
#include "support/statistics.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

using reference::Geometry;
using reference::Light;
using reference::Lights;
using reference::TreeChoice;

constexpr glm::dvec3 kUp{0.0, 1.0, 0.0};

/// Small lights of all kinds in a ball of radius 5, of powers over three decades. Every second one
/// emits from its front only.
Scene strewnLights(uint32_t count, const glm::dvec3& background = glm::dvec3(0.0)) {
    RandomNumbers random(311);
    std::vector<Shape> shapes;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 p = 5.0 * random.inBall();
        const double size = random.powerOfTen(-2.0, -0.5);
        const glm::dvec3 y = random.direction();
        const glm::dvec3 x = glm::normalize(glm::cross(y, random.direction()));
        const RigidTransform place{{x, y, glm::cross(x, y)}, p};
        if (i % 5 == 0)
            shapes.push_back(shapeOf(Sphere{place, size}, i % 2));
        else if (i % 5 == 1)
            shapes.push_back(shapeOf(Disk{place, size}, i % 2));
        else if (i % 5 == 2)
            shapes.push_back(shapeOf(Cylinder{place, size, size}, i % 2));
        else {
            Mesh triangle = singleTriangle(p, p + size * x, p + size * y);
            triangle.triangles[0].material = i % 2;
            shapes.push_back(shapeOf(std::move(triangle), i % 2));
        }
    }
    Scene scene = sceneOf(std::move(shapes));
    scene.materials.resize(2);
    scene.materials[0].emission = {1.0, 0.5, 0.2};
    scene.materials[1].emission = glm::dvec3(3.0);
    scene.materials[1].emitsFromFrontOnly = true;
    scene.background = background;
    return scene;
}

TEST(ReferenceLightTreeTest, ProbabilitiesAddUpToOne) {
    for (const uint32_t count : {2u, 3u, 20u, 500u})
        for (const double background : {0.0, 0.3}) {
            const Scene scene = strewnLights(count, glm::dvec3(background));
            const Geometry geometry(scene);
            const Lights lights(scene, geometry, LightChoice::Tree);
            RandomNumbers random(312);
            for (int i = 0; i < 30; ++i) {
                const glm::dvec3 p = 6.0 * random.inBall();
                double sum = 0.0;
                for (const auto& light : lights.all())
                    sum += lights.probability(*light, p);
                EXPECT_NEAR(sum, 1.0, 1e-12);
            }
        }
}

TEST(ReferenceLightTreeTest, ChoosesWithTheProbabilities) {
    const Scene scene = strewnLights(60, glm::dvec3(0.02));
    const Geometry geometry(scene);
    const Lights lights(scene, geometry, LightChoice::Tree);
    RandomNumbers random(313);
    for (const glm::dvec3 p : {glm::dvec3(0.0), glm::dvec3(3.0, 1.0, -2.0), glm::dvec3(40.0)}) {
        std::vector<uint64_t> counts(lights.all().size());
        std::vector<double> sums(counts.size());
        std::vector<double> chances;
        for (const auto& light : lights.all())
            chances.push_back(lights.probability(*light, p));
        for (int i = 0; i < 200'000; ++i) {
            const auto choice = lights.choose({p}, {random.deviceUnit(), random.deviceUnit()});
            const uint32_t index = choice.light.primitive().value_or(60);
            ASSERT_EQ(choice.probability, chances[index]);
            ASSERT_GE(choice.u, 0.0);
            ASSERT_LE(choice.u, 1.0);
            ++counts[index];
            sums[index] += choice.u;
        }
        // Rare lights are counted together.
        std::vector<uint64_t> common = {0};
        std::vector<double> ofCommon = {0.0};
        for (size_t i = 0; i < counts.size(); ++i) {
            if (chances[i] < 1e-4) {
                common[0] += counts[i];
                ofCommon[0] += chances[i];
                continue;
            }
            common.push_back(counts[i]);
            ofCommon.push_back(chances[i]);
            EXPECT_NEAR(sums[i] / double(counts[i]), 0.5,
                        5.0 / std::sqrt(12.0 * double(counts[i])));
        }
        if (ofCommon[0] < 1e-4) {
            common.erase(common.begin());
            ofCommon.erase(ofCommon.begin());
        }
        EXPECT_LT(chiSquare(common, ofCommon), chiSquareLimit(common.size() - 1));
    }
}

// The mean of the inverse probability is the number of lights that may be chosen.
TEST(ReferenceLightTreeTest, ChoosesWithTheNormal) {
    const Scene scene = strewnLights(40);
    const Geometry geometry(scene);
    const Lights lights(scene, geometry, LightChoice::Tree);
    RandomNumbers random(316);
    const glm::dvec3 p(1.0, -2.0, 0.5);
    std::vector<double> inverse;
    std::vector<double> chances(lights.all().size());
    for (int i = 0; i < 100'000; ++i) {
        const auto choice = lights.choose({p, kUp}, {random.deviceUnit(), random.deviceUnit()});
        ASSERT_EQ(choice.probabilityForMis, lights.probability(choice.light, p));
        chances[*choice.light.primitive()] = choice.probability;
        inverse.push_back(1.0 / choice.probability);
    }
    double sum = 0.0;
    double possible = 0.0;
    for (const double chance : chances) {
        sum += chance;
        possible += chance > 0.0 ? 1.0 : 0.0;
    }
    EXPECT_LT(possible, 38.0); // not those below the plane, and those that face away
    EXPECT_GT(possible, 15.0);
    EXPECT_NEAR(sum, 1.0, 1e-3); // of the lights that were seen
    const Estimate mean = estimate(inverse);
    EXPECT_NEAR(mean.mean, possible, 5.0 * mean.standardError);
}

TEST(ReferenceLightTreeTest, BackgroundKeepsItsProbability) {
    const Scene scene = strewnLights(40, glm::dvec3(1e-3));
    const Geometry geometry(scene);
    const Lights byPower(scene, geometry, LightChoice::Power);
    const Lights byTree(scene, geometry, LightChoice::Tree);
    const double expected = byPower.infinite()->selectionProbability;
    EXPECT_GT(expected, 0.001);
    EXPECT_LT(expected, 0.499);
    EXPECT_EQ(byTree.probability(*byTree.infinite(), {1.0, 2.0, 3.0}), expected);
}

TEST(ReferenceLightTreeTest, OfOneLightIsTheTable) {
    const Scene scene = strewnLights(1, glm::dvec3(0.1));
    const Geometry geometry(scene);
    const Lights byPower(scene, geometry, LightChoice::Power);
    const Lights byTree(scene, geometry, LightChoice::Tree);
    for (size_t i = 0; i < 2; ++i)
        EXPECT_EQ(byTree.probability(*byTree.all()[i], {}),
                  byPower.probability(*byPower.all()[i], {}));
}

/// The irradiance on a floor at the origin from a disk of radius r that faces it, at height h above
/// it (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-12).
double irradianceBelow(double radiance, double r, double h) {
    return std::numbers::pi * radiance * r * r / (r * r + h * h);
}

// What each light sends is known, so the sum over choices is the sum of both.
TEST(ReferenceLightTreeTest, TwoLampsLightTheFloorByTheirSum) {
    Scene scene = sceneOf({shapeOf(Disk{{glm::dmat3(1.0), {0.0, 0.3, 0.0}}, 0.01}, 0),
                           shapeOf(Disk{{glm::dmat3(1.0), {0.0, 20.0, 0.0}}, 8.0}, 1)});
    scene.materials.resize(2);
    scene.materials[0].emission = glm::dvec3(900.0);
    scene.materials[1].emission = glm::dvec3(2.0);
    const Geometry geometry(scene);
    const Lights lights(scene, geometry, LightChoice::Tree);
    RandomNumbers random(314);
    std::vector<double> values;
    for (int i = 0; i < 400'000; ++i) {
        const auto choice =
            lights.choose({glm::dvec3(0.0), kUp}, {random.deviceUnit(), random.deviceUnit()});
        const Light::Sample sample = choice.light.sample({}, {choice.u, random.unit()});
        const double radiance = choice.light.radiance(sample.wi, sample.point).x;
        values.push_back(radiance * sample.wi.y / (sample.pdf * choice.probability));
    }
    const Estimate seen = estimate(values);
    const double expected = irradianceBelow(900.0, 0.01, 0.3) + irradianceBelow(2.0, 8.0, 20.0);
    EXPECT_NEAR(seen.mean, expected, 4.0 * seen.standardError);
    EXPECT_LT(seen.standardError, 1e-3 * expected); // both are chosen by what they send
}

// Wherever a point of a light sends light, no cluster on the way to it has an importance of 0.
TEST(ReferenceLightTreeTest, NoLightThatShinesIsLeftOut) {
    const Scene scene = strewnLights(200);
    const Geometry geometry(scene);
    const Lights lights(scene, geometry, LightChoice::Tree);
    const std::vector<PrimitiveLight> clusters = primitiveLights(scene);
    const auto clusterOf = [&](const Light& light) { return clusters[*light.primitive()].cluster; };
    RandomNumbers random(315);
    int dark = 0;
    int lit = 0;
    for (int i = 0; i < 20'000; ++i) {
        const glm::dvec3 p = 8.0 * random.inBall();
        const Light& light = *lights.all()[random.below(200)];
        const Light::Sample sample = light.sample(p, {random.unit(), random.unit()});
        const double chance = lights.probability(light, p);
        const bool shines =
            sample.pdf > 0.0 && light.radiance(sample.wi, sample.point) != glm::dvec3(0.0);
        ASSERT_TRUE(!shines || chance > 0.0);
        dark += chance == 0.0;
        lit += shines;
        const glm::dvec3 normal = random.direction();
        ASSERT_TRUE(glm::dot(sample.wi, normal) <= 0.0 ||
                    reference::receivedShare(clusterOf(light), {p, normal}) > 0.0);
    }
    EXPECT_GT(dark, 2000); // those that face away are left out
    EXPECT_GT(lit, 10'000);
}

TEST(ReferenceLightTreeTest, ImportanceIsThatOfItsEquation) {
    // A flat light of power 2 at the origin, in a sphere of radius 0.1, seen at an angle of 60
    // degrees from 10 m.
    LightCluster cluster;
    cluster.bounds = {glm::dvec3(-0.1 / std::sqrt(3.0)), glm::dvec3(0.1 / std::sqrt(3.0))};
    cluster.power = 2.0;
    const double third = std::numbers::pi / 3.0;
    const glm::dvec3 seenFrom = 10.0 * glm::dvec3(std::sin(third), std::cos(third), 0.0);
    const double more = 0.01 + 1.0 / 512.0; // the sine of the sphere's angle, and the error
    const auto emitted = [&] { return reference::emittedImportance(cluster, seenFrom); };
    EXPECT_NEAR(emitted(), 2.0 * (0.5 + more) / 100.0, 1e-12);
    EXPECT_EQ(reference::emittedImportance(cluster, -seenFrom), 0.0);
    cluster.isTwoSided = true;
    EXPECT_NEAR(reference::emittedImportance(cluster, -seenFrom), emitted(), 1e-15);
    cluster.thetaO = 0.2;
    EXPECT_NEAR(emitted(), 2.0 * (std::cos(third - 0.2) + more) / 100.0, 1e-12);
    cluster.thetaO = 1.2;
    EXPECT_NEAR(emitted(), 2.0 / 100.0, 1e-12);
    EXPECT_NEAR(reference::emittedImportance(cluster, {0.0, 0.05, 0.0}), 2.0 / 0.01, 1e-9);

    const glm::dvec3 toLight = -0.1 * seenFrom;
    const glm::dvec3 across(toLight.y, -toLight.x, 0.0);
    const auto received = [&](const glm::dvec3& normal) {
        return reference::receivedShare(cluster, {seenFrom, normal});
    };
    EXPECT_NEAR(received(toLight), 1.0, 1e-12);
    EXPECT_NEAR(received(across), more, 1e-12);
    EXPECT_NEAR(received(0.6 * toLight + 0.8 * across), 0.6 + more, 1e-12);
    EXPECT_EQ(received(-toLight), 0.0);
    EXPECT_EQ(reference::receivedShare(cluster, {seenFrom}), 1.0);
    EXPECT_EQ(reference::receivedShare(cluster, {{0.0, 0.05, 0.0}, kUp}), 1.0);
}

} // namespace
} // namespace calotype::test
