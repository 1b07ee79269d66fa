// The choice of lights through a tree, in the kernel.
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "kernels/choose_light.spv.h"
#include "reference/lights.h"
#include "render/scene_buffers.h"
#include "support/chi_square.h"
#include "support/gpu_test.h"
#include "support/kernels/test_structs.h"
#include "support/random_numbers.h"
#include "support/scene_builder.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

/// Lights of all kinds in a ball of radius 5 times `scale`, of powers over three decades. Every
/// second one emits from its front only.
Scene strewnLamps(uint32_t count, const glm::dvec3& background, double scale = 1.0) {
    RandomNumbers random(321);
    std::vector<Shape> shapes;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 p = scale * 5.0 * random.inBall();
        const double size = scale * random.powerOfTen(-2.5, -1.0);
        const glm::dvec3 y = random.direction();
        const glm::dvec3 x = glm::normalize(glm::cross(y, random.direction()));
        const RigidTransform place{{x, y, glm::cross(x, y)}, p};
        if (i % 5 == 0) {
            shapes.push_back(shapeOf(Sphere{place, size}, i % 2));
        } else if (i % 5 == 1) {
            shapes.push_back(shapeOf(Disk{place, size}, i % 2));
        } else if (i % 5 == 2) {
            shapes.push_back(shapeOf(Cone{place, size, 0.5}, i % 2));
        } else {
            Mesh triangle = singleTriangle(p, p + size * x, p + size * y);
            triangle.triangles[0].material = i % 2;
            shapes.push_back(shapeOf(std::move(triangle)));
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

class LightTreeChoiceTest : public GpuTest {
protected:
    using Query = shared::TestChoiceQuery;
    using Choice = shared::TestLightChoice;

    /// With a number for the choice, at a point in the world, which has a normal or none (0).
    static Query query(const GpuScene& packed, const glm::dvec3& point, const glm::vec2& u,
                       uint32_t light = 0, const glm::dvec3& normal = {}) {
        return {glm::vec3(point - packed.origin),
                light,
                glm::vec3(normal),
                packed.lightCount,
                u,
                packed.infiniteLight,
                packed.lightTreeDepth};
    }

    static glm::vec2 deviceUnits(RandomNumbers& random) {
        const float x = random.deviceUnit();
        return {x, random.deviceUnit()};
    }

    static std::vector<Choice> choose(const GpuScene& packed, const std::vector<Query>& queries) {
        const SceneBuffers buffers(testDevice(), packed);
        return runKernel<Choice>(kChooseLightSpirv, queries, buffers.bindings(), kTestInputBinding);
    }

    /// The probability of each light at a point.
    static std::vector<double> probabilities(const GpuScene& packed, const glm::dvec3& point) {
        std::vector<Query> queries;
        for (uint32_t light = 0; light < packed.lightCount; ++light)
            queries.push_back(query(packed, point, {}, light));
        std::vector<double> chances;
        for (const Choice& choice : choose(packed, queries))
            chances.push_back(choice.probabilityOfGiven);
        return chances;
    }
};

constexpr glm::dvec3 kPoints[] = {{0.0, 0.0, 0.0}, {3.0, 1.0, -2.0}, {40.0, 30.0, 2.0}};

// The probabilities are those that come with the choices. Rare lights are counted together with
// those that were never chosen.
TEST_F(LightTreeChoiceTest, HappensWithTheProbabilities) {
    const GpuScene packed =
        packAsProgram(strewnLamps(60, glm::dvec3(0.02)), LightChoice::Tree).packed;
    ASSERT_GT(packed.lightTreeDepth, 5u);
    RandomNumbers random(322);
    for (const glm::dvec3& p : kPoints) {
        std::vector<Query> queries;
        const glm::dvec3 normal = random.direction();
        for (int i = 0; i < 400'000; ++i)
            queries.push_back(query(packed, p, deviceUnits(random), 0, normal));
        std::vector<double> chances(packed.lightCount);
        std::vector<uint64_t> counts(packed.lightCount);
        std::vector<double> sums(packed.lightCount);
        for (const Choice& choice : choose(packed, queries)) {
            ASSERT_LT(choice.light, packed.lightCount);
            ASSERT_GE(choice.u, 0.0f);
            ASSERT_LT(choice.u, 1.0f);
            ASSERT_TRUE(counts[choice.light] == 0 || chances[choice.light] == choice.probability);
            chances[choice.light] = choice.probability;
            ++counts[choice.light];
            sums[choice.light] += choice.u;
        }
        std::vector<uint64_t> seen = {0};
        std::vector<double> expected = {1.0};
        for (size_t i = 0; i < chances.size(); ++i) {
            if (chances[i] < 5e-5) {
                seen[0] += counts[i];
                continue;
            }
            seen.push_back(counts[i]);
            expected.push_back(chances[i]);
            expected[0] -= chances[i];
            EXPECT_NEAR(sums[i] / double(counts[i]), 0.5,
                        5.0 / std::sqrt(12.0 * double(counts[i])));
        }
        EXPECT_GT(seen.size(), 10u);
        EXPECT_GT(expected[0], -1e-5);
        if (expected[0] < 5e-5) {
            EXPECT_LT(seen[0], 60u);
            seen.erase(seen.begin());
            expected.erase(expected.begin());
        }
        EXPECT_LT(chiSquare(seen, expected), chiSquareLimit(seen.size() - 1));
    }
}

TEST_F(LightTreeChoiceTest, ProbabilitiesAreThoseOfTheReferenceAndAddUpToOne) {
    for (const uint32_t count : {2u, 3u, 50u, 3000u})
        for (const double background : {0.0, 0.02}) {
            const Scene scene = strewnLamps(count, glm::dvec3(background));
            const GpuScene packed = packAsProgram(scene, LightChoice::Tree).packed;
            const reference::Geometry geometry(scene);
            const reference::Lights lights(scene, geometry, LightChoice::Tree);
            for (const glm::dvec3& p : kPoints) {
                const std::vector<double> chances = probabilities(packed, p);
                double sum = 0.0;
                for (uint32_t i = 0; i < chances.size(); ++i) {
                    const double expected = lights.probability(*lights.all()[i], p);
                    // A cosine is off by eight roundings; near 0 that is much of an importance.
                    EXPECT_NEAR(chances[i], expected, 1e-3 * expected + 8.0 * 0x1p-24) << i;
                    sum += chances[i];
                }
                EXPECT_NEAR(sum, 1.0, 1e-5);
            }
        }
}

// Light that a ray finds is weighted by the same probability as if light sampling had found it.
TEST_F(LightTreeChoiceTest, ProbabilityOfTheTrailIsThatOfTheChoiceToTheLastBit) {
    const GpuScene packed =
        packAsProgram(strewnLamps(3000, glm::dvec3(0.02)), LightChoice::Tree).packed;
    RandomNumbers random(323);
    std::vector<Query> queries;
    for (int i = 0; i < 50'000; ++i)
        queries.push_back(query(packed, 7.0 * random.inBall(), deviceUnits(random), 0,
                                i % 2 == 0 ? random.direction() : glm::dvec3(0.0)));
    const std::vector<Choice> choices = choose(packed, queries);
    for (size_t i = 0; i < queries.size(); ++i)
        queries[i].light = choices[i].light;
    const std::vector<Choice> again = choose(packed, queries);
    for (size_t i = 0; i < queries.size(); ++i) {
        ASSERT_GT(choices[i].probability, 0.0f);
        ASSERT_EQ(choices[i].probabilityForMis, again[i].probabilityOfGiven);
    }
}

// The reference chooses the same lights by the same numbers, with the same probabilities, except
// where a share is so near 0 that rounding is much of it.
TEST_F(LightTreeChoiceTest, ChoosesAsTheReferenceDoesWithANormal) {
    const Scene scene = strewnLamps(500, glm::dvec3(0.02));
    const GpuScene packed = packAsProgram(scene, LightChoice::Tree).packed;
    const reference::Geometry geometry(scene);
    const reference::Lights lights(scene, geometry, LightChoice::Tree);
    RandomNumbers random(327);
    std::vector<Query> queries;
    std::vector<reference::LitPoint> points;
    for (int i = 0; i < 20'000; ++i) {
        const glm::dvec3 p = 7.0 * random.inBall();
        const glm::dvec3 normal = random.direction();
        queries.push_back(query(packed, p, deviceUnits(random), 0, normal));
        points.push_back({p, normal});
    }
    const std::vector<Choice> choices = choose(packed, queries);
    size_t others = 0;
    for (size_t i = 0; i < queries.size(); ++i) {
        const auto expected = lights.choose(points[i], glm::dvec2(queries[i].u));
        const uint32_t light = expected.light.primitive().value_or(packed.infiniteLight);
        const auto differs = [](float seen, double probability) {
            return std::abs(seen - probability) > 1e-3 * probability + 1e-8;
        };
        others += choices[i].light != light ||
                  differs(choices[i].probability, expected.probability) ||
                  differs(choices[i].probabilityForMis, expected.probabilityForMis);
    }
    EXPECT_LT(others, queries.size() / 200);
}

// A number that is used again has digits enough for the place on any of 100,000 lights: the places
// are uniform, and so are the digits of theirs that a number of 24 bits would not have left.
TEST_F(LightTreeChoiceTest, PlacesOnRareLightsAreUniform) {
    SceneBuilder builder;
    builder.material(0.0, 1.0, true);
    constexpr uint32_t kAcross = 316;
    constexpr uint32_t kNo = Mesh::kNoNormal;
    Mesh lamps;
    for (uint32_t i = 0; i < kAcross * kAcross; ++i) {
        const double x = i % kAcross;
        const double z = i / kAcross;
        lamps.positions.insert(lamps.positions.end(),
                               {{x, 0.0, z}, {x + 0.1, 0.0, z}, {x, 0.0, z + 0.1}});
        lamps.triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, {kNo, kNo, kNo}, 0});
    }
    builder.add(makeShape(std::move(lamps), 0));
    const GpuScene packed = packAsProgram(builder.scene(), LightChoice::Tree).packed;
    RandomNumbers random(324);
    std::vector<Query> queries;
    for (int i = 0; i < 200'000; ++i)
        queries.push_back(query(packed, {158.0, -2000.0, 158.0}, deviceUnits(random)));
    constexpr size_t kBins = 64;
    std::vector<uint64_t> counts(kBins);
    std::vector<uint64_t> digits(kBins); // the fraction of 2^12 u: digits that 24 bits do not have
    for (const Choice& choice : choose(packed, queries)) {
        ASSERT_LT(choice.probability, 3e-5f);
        const double u = choice.u;
        ++counts[static_cast<size_t>(u * kBins)];
        const double fine = std::ldexp(u, 12);
        ++digits[static_cast<size_t>((fine - std::floor(fine)) * kBins)];
    }
    const std::vector<double> alike(kBins, 1.0 / kBins);
    EXPECT_LT(chiSquare(counts, alike), chiSquareLimit(kBins - 1));
    EXPECT_LT(chiSquare(digits, alike), chiSquareLimit(kBins - 1));
}

TEST_F(LightTreeChoiceTest, ChoiceIsTheSameInAnyUnitOfLength) {
    const GpuScene packed = packAsProgram(strewnLamps(500, {}), LightChoice::Tree).packed;
    RandomNumbers random(325);
    std::vector<Query> queries;
    for (int i = 0; i < 20'000; ++i)
        queries.push_back(
            query(packed, 7.0 * random.inBall(), deviceUnits(random), i % 500, random.direction()));
    const std::vector<Choice> expected = choose(packed, queries);
    for (const int exponent : {-12, 3, 20}) {
        const float scale = std::ldexp(1.0f, exponent);
        const GpuScene scaled =
            packAsProgram(strewnLamps(500, {}, double(scale)), LightChoice::Tree).packed;
        std::vector<Query> scaledQueries = queries;
        for (size_t i = 0; i < queries.size(); ++i)
            scaledQueries[i].shadingPoint *= scale;
        const std::vector<Choice> seen = choose(scaled, scaledQueries);
        for (size_t i = 0; i < queries.size(); ++i) {
            ASSERT_EQ(seen[i].light, expected[i].light);
            ASSERT_EQ(seen[i].u, expected[i].u);
            ASSERT_EQ(seen[i].probability, expected[i].probability);
            ASSERT_EQ(seen[i].probabilityOfGiven, expected[i].probabilityOfGiven);
        }
    }
}

// From points just above the plane of a light, and near cones that just reach them: rounding does
// not make an importance 0.
TEST_F(LightTreeChoiceTest, GrazingLightIsNotLeftOut) {
    RandomNumbers random(326);
    for (const double distance : {0.02, 1.0, 100.0}) {
        SceneBuilder builder;
        builder.material(0.0, 1.0, true);
        std::vector<glm::dvec3> points;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 y = random.direction();
            const glm::dvec3 x = glm::normalize(glm::cross(y, random.direction()));
            const glm::dvec3 z = glm::cross(x, y);
            const glm::dvec3 p = 10.0 * random.inBall();
            builder.polygon({p, p + 0.01 * x, p - 0.01 * z}, 0); // its front is along y
            const double up = random.powerOfTen(-6.0, -3.0);
            points.push_back(p + distance * (std::cos(up) * x + std::sin(up) * y));
        }
        const GpuScene packed = packAsProgram(builder.scene(), LightChoice::Tree).packed;
        std::vector<Query> queries;
        for (uint32_t i = 0; i < points.size(); ++i)
            queries.push_back(query(packed, points[i], {}, i));
        for (const Choice& choice : choose(packed, queries))
            ASSERT_GT(choice.probabilityOfGiven, 0.0f);
    }
}

// Beside a light of 10^12 times its power, whichever of the two comes first: a probability that
// rounds to 0 would lose the light of the weaker one where the other is blocked.
TEST_F(LightTreeChoiceTest, AWeakLightKeepsAProbability) {
    for (const double ratio : {1e-5, 1e-7, 1e-8, 1e-10, 1e-12})
        for (const bool isWeakFirst : {false, true}) {
            SceneBuilder builder;
            const uint32_t weak = builder.material(0.0, ratio);
            const uint32_t strong = builder.material(0.0, 1.0);
            for (int i = 0; i < 2; ++i) {
                const RigidTransform place{glm::dmat3(1.0), {i == 0 ? -1.0 : 1.0, 0.0, 0.0}};
                builder.add(makeShape(Sphere{place, 0.1}, (i == 0) == isWeakFirst ? weak : strong));
            }
            for (const double probability :
                 probabilities(packAsProgram(builder.scene(), LightChoice::Tree).packed, {}))
                EXPECT_GT(probability, 0.0) << ratio << " " << isWeakFirst;
        }
}

TEST_F(LightTreeChoiceTest, IsThereForTwoLightsOrMoreOnly) {
    for (const uint32_t count : {1u, 2u}) {
        const Scene scene = strewnLamps(count, glm::dvec3(0.1));
        const GpuScene packed = packAsProgram(scene, LightChoice::Tree).packed;
        EXPECT_EQ(packed.features.enabled[shared::kFeatureLightTree], count == 2);
        EXPECT_EQ(packed.lightTreeDepth, count - 1);
        const GpuScene byPower = packAsProgram(scene).packed;
        EXPECT_FALSE(byPower.features.enabled[shared::kFeatureLightTree]);
        EXPECT_EQ(byPower.lightNodes.size(), 1u); // unused
        EXPECT_EQ(packed.lights[packed.infiniteLight].selectionProbability,
                  byPower.lights[byPower.infiniteLight].selectionProbability);
    }
}

} // namespace
} // namespace calotype::test
