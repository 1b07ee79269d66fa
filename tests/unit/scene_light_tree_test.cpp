// Clusters of lights, and the tree over them.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "reference/geometry.h"
#include "reference/lights.h"
#include "scene/light_tree.h"
#include "support/random_numbers.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

constexpr double kPi = std::numbers::pi;

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// How far the normal is outside of the cluster's cone, radians; not positive inside.
double outsideOf(const LightCluster& cluster, const glm::dvec3& normal) {
    const double angle = angleBetween(cluster.axis, normal);
    return (cluster.isTwoSided ? std::min(angle, kPi - angle) : angle) - cluster.thetaO;
}

bool isInside(const Bounds3d& bounds, const glm::dvec3& p, double slack) {
    return glm::all(glm::greaterThanEqual(p, bounds.lower - slack)) &&
           glm::all(glm::lessThanEqual(p, bounds.upper + slack));
}

LightCluster flatLight(RandomNumbers& random, const glm::dvec3& center, double size) {
    LightCluster light;
    light.bounds.extend(center - size);
    light.bounds.extend(center + size);
    light.axis = random.direction();
    light.power = random.powerOfTen(-3.0, 3.0);
    return light;
}

std::vector<LightCluster> lightsInBall(uint32_t count, uint64_t seed) {
    RandomNumbers random(seed);
    std::vector<LightCluster> lights;
    for (uint32_t i = 0; i < count; ++i)
        lights.push_back(flatLight(random, 10.0 * random.inBall(), 0.01));
    return lights;
}

/// Follows the trail of each light; fails where it does not end at the light.
void expectTrailsLead(const LightTree& tree, size_t lights) {
    ASSERT_EQ(tree.trails.size(), lights);
    ASSERT_EQ(tree.nodes.size(), lights - 1);
    ASSERT_LE(tree.depth, LightTree::kMostDepth);
    uint32_t deepest = 0;
    for (uint32_t light = 0; light < lights; ++light) {
        uint32_t trail = tree.trails[light];
        LightTree::Child child;
        uint32_t depth = 0;
        do {
            ASSERT_LT(depth, tree.depth);
            child = tree.nodes[child.index].children[trail & 1];
            trail >>= 1;
            ++depth;
        } while (!child.isLight);
        ASSERT_EQ(child.index, light);
        ASSERT_EQ(trail, 0u);
        deepest = std::max(deepest, depth);
    }
    EXPECT_EQ(deepest, tree.depth);
}

/// Each cluster contains what is below it.
void expectClustersContain(const LightTree& tree, const std::vector<LightCluster>& lights) {
    for (uint32_t light = 0; light < lights.size(); ++light) {
        uint32_t trail = tree.trails[light];
        LightTree::Child child;
        do {
            child = tree.nodes[child.index].children[trail & 1];
            trail >>= 1;
            ASSERT_TRUE(child.cluster.bounds.contains(lights[light].bounds));
            ASSERT_GE(child.cluster.power, lights[light].power);
            for (const double side : {1.0, -1.0})
                if (side > 0.0 || lights[light].isTwoSided) {
                    ASSERT_LT(outsideOf(child.cluster, side * lights[light].axis) +
                                  lights[light].thetaO,
                              1e-7);
                }
        } while (!child.isLight);
    }
}

TEST(LightClusterTest, HoldsThePointsAndNormalsOfALight) {
    const glm::dmat3 turn(glm::dvec3(0.6, 0.8, 0.0), glm::dvec3(-0.8, 0.6, 0.0),
                          glm::dvec3(0.0, 0.0, 1.0));
    const RigidTransform place{turn, {1.0, 2.0, -3.0}};
    const std::pair<Shape, double> shapes[] = {
        {shapeOf(Sphere{place, 0.7}), 4.0 * kPi * 0.49},
        {shapeOf(Cylinder{place, 0.5, 1.5}), 2.0 * kPi * 0.25 + kPi * 1.5},
        {shapeOf(Cone{place, -1.2, 0.5}), kPi * 0.6 * (0.6 + std::hypot(0.6, 1.2))},
        {shapeOf(Disk{place, 0.4}), kPi * 0.16},
        {shapeOf(singleTriangle({0, 1, 0}, {1, 2, 0}, {0, 2, 1})), 0.5 * std::sqrt(3.0)}};
    RandomNumbers random(301);
    for (const auto& [shape, area] : shapes)
        for (const bool frontOnly : {true, false}) {
            Scene scene = sceneOf({shape});
            scene.materials[0].emission = {1.0, 2.0, 3.0};
            scene.materials[0].emitsFromFrontOnly = frontOnly;
            const std::vector<PrimitiveLight> found = primitiveLights(scene);
            ASSERT_EQ(found.size(), 1u);
            const LightCluster& cluster = found[0].cluster;
            const double luminance = 0.2126 + 2.0 * 0.7152 + 3.0 * 0.0722;
            EXPECT_NEAR(cluster.power, luminance * area * (frontOnly ? 1.0 : 2.0), 1e-12);
            const reference::Geometry geometry(scene);
            const reference::Lights lights(scene, geometry);
            for (int i = 0; i < 2000; ++i) {
                const auto sample = lights.ofPrimitive(0)->sample(
                    place.translation + 3.0 * random.inBall(), {random.unit(), random.unit()});
                EXPECT_TRUE(isInside(cluster.bounds, sample.point.position, 1e-9));
                EXPECT_LT(outsideOf(cluster, sample.point.normal), 1e-7);
                EXPECT_LT(frontOnly ? 0.0 : outsideOf(cluster, -sample.point.normal), 1e-7);
            }
        }
}

TEST(LightClusterTest, IsOfThePrimitivesThatEmit) {
    std::vector<Shape> shapes = {shapeOf(cubeMesh(1), 0), shapeOf(Sphere{{}, 1.0}, 1),
                                 shapeOf(cubeMesh(1), 1), shapeOf(Disk{{}, 0.0}, 1)};
    std::get<Mesh>(shapes[0].geometry).triangles[5].material = 1;
    Scene scene = sceneOf(shapes);
    for (Mesh::Triangle& triangle : std::get<Mesh>(scene.shapes[2].geometry).triangles)
        triangle.material = 1;
    scene.materials.resize(2);
    scene.materials[1].emission = glm::dvec3(1.0);
    std::vector<uint32_t> primitives;
    for (const PrimitiveLight& light : primitiveLights(scene))
        primitives.push_back(light.primitive);
    std::vector<uint32_t> expected = {5, 12};
    for (uint32_t i = 13; i < 25; ++i)
        expected.push_back(i);
    EXPECT_EQ(primitives, expected); // not the disk without area
    EXPECT_TRUE(hasMorePrimitiveLightsThan(14, scene));
    EXPECT_FALSE(hasMorePrimitiveLightsThan(15, scene));
    scene.materials[1].emission = glm::dvec3(0.0);
    EXPECT_FALSE(hasMorePrimitiveLightsThan(0, scene));
}

TEST(LightClusterTest, JoinedHoldsBoth) {
    RandomNumbers random(302);
    for (int i = 0; i < 20'000; ++i) {
        LightCluster clusters[2];
        for (LightCluster& cluster : clusters) {
            cluster = flatLight(random, random.inBall(), 0.1);
            cluster.thetaO = random.coin() ? 0.0 : random.between(0.0, kPi);
            cluster.isTwoSided = random.coin();
        }
        if (i % 4 == 0)
            clusters[1].axis = random.sign() * clusters[0].axis;
        const LightCluster both = joined(clusters[0], clusters[1]);
        EXPECT_NEAR(glm::length(both.axis), 1.0, 1e-12);
        EXPECT_DOUBLE_EQ(both.power, clusters[0].power + clusters[1].power);
        for (const LightCluster& cluster : clusters) {
            EXPECT_TRUE(both.bounds.contains(cluster.bounds));
            // A normal at the edge of the cone.
            const glm::dvec3 across = glm::normalize(glm::cross(cluster.axis, random.direction()));
            const glm::dvec3 normal =
                std::cos(cluster.thetaO) * cluster.axis + std::sin(cluster.thetaO) * across;
            ASSERT_LT(outsideOf(both, normal), 1e-7);
            ASSERT_LT(cluster.isTwoSided ? outsideOf(both, -normal) : 0.0, 1e-7);
        }
    }
}

TEST(LightTreeTest, TrailsLeadToTheLights) {
    for (const uint32_t count : {2u, 3u, 4u, 17u, 1000u}) {
        const std::vector<LightCluster> lights = lightsInBall(count, 303);
        const LightTree tree = buildLightTree(lights);
        expectTrailsLead(tree, count);
        expectClustersContain(tree, lights);
    }
}

TEST(LightTreeTest, HasNoNodeForOneLight) {
    for (const uint32_t count : {0u, 1u}) {
        const LightTree tree = buildLightTree(lightsInBall(count, 304));
        EXPECT_TRUE(tree.nodes.empty());
        EXPECT_EQ(tree.depth, 0u);
    }
}

// Each split at the middle of the distances would take one light off.
TEST(LightTreeTest, DepthIsBoundedHoweverLightsLie) {
    std::vector<LightCluster> lights(1000);
    RandomNumbers random(305);
    for (size_t i = 0; i < lights.size(); ++i)
        lights[i] = flatLight(random, glm::dvec3(std::pow(0.8, double(i)), 0.0, 0.0), 0.0);
    expectTrailsLead(buildLightTree(lights), lights.size());
    for (LightCluster& light : lights) // in one place
        light.bounds = lights[0].bounds;
    const LightTree tree = buildLightTree(lights);
    expectTrailsLead(tree, lights.size());
    EXPECT_EQ(tree.depth, 10u);
}

TEST(LightTreeTest, SplitsWhatIsApart) {
    // Two groups; and in one place, lamps that face up and down.
    RandomNumbers random(306);
    std::vector<LightCluster> lights;
    for (int i = 0; i < 64; ++i) {
        lights.push_back(flatLight(random, {i % 2 == 0 ? -50.0 : 50.0, 0.1 * i, 0.0}, 0.01));
        lights.back().power = 1.0;
    }
    const LightTree tree = buildLightTree(lights);
    for (uint32_t i = 0; i < lights.size(); ++i)
        EXPECT_EQ(tree.trails[i] & 1, tree.trails[i % 2] & 1);
    EXPECT_NE(tree.trails[0] & 1, tree.trails[1] & 1);
}

TEST(LightTreeTest, FormDoesNotDependOnTheUnitOfLength) {
    std::vector<LightCluster> lights = lightsInBall(500, 307);
    const LightTree tree = buildLightTree(lights);
    for (const int exponent : {-30, 1, 40}) {
        std::vector<LightCluster> scaled = lights;
        for (LightCluster& light : scaled) {
            light.bounds.lower *= std::ldexp(1.0, exponent);
            light.bounds.upper *= std::ldexp(1.0, exponent);
        }
        EXPECT_EQ(buildLightTree(scaled).trails, tree.trails);
    }
}

} // namespace
} // namespace calotype::test
