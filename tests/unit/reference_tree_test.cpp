#include <gtest/gtest.h>

#include "unit/reference_shapes.h"

// The tree must find what an intersection with every primitive finds: the same t to the last bit.

namespace calotype::test {
namespace {

using reference::Geometry;
using reference::Ray;

enum class Arrangement { Scattered, Clustered, Coincident };

struct Crowd {
    std::string name;
    uint32_t count;
    Arrangement arrangement;
    double size = 1.0;
    double distance = 0.0; ///< from the world's origin, in sizes
};

Shape randomShape(const glm::dvec3& center, double size, RandomNumbers& random) {
    const uint32_t kind = random.below(5);
    if (kind < kQuadricKinds.size())
        return randomQuadric(kQuadricKinds[kind], center, size, random);
    return shapeOf(singleTriangle(center + size * random.inBall(), center + size * random.inBall(),
                                  center + size * random.inBall()));
}

std::vector<Shape> makeCrowd(const Crowd& crowd, const glm::dvec3& center, RandomNumbers& random) {
    std::vector<Shape> shapes;
    const double spacing = crowd.size / std::cbrt(crowd.count);
    for (uint32_t i = 0; i < crowd.count; ++i) {
        if (crowd.arrangement == Arrangement::Coincident && i % 3 != 0) {
            shapes.push_back(shapes.back());
        } else if (crowd.arrangement == Arrangement::Clustered) {
            // Each half as large as the one before it and half as far: 2^-166 in the end.
            const double scale = crowd.size * std::pow(2.0, -double(i) / 3.0);
            shapes.push_back(randomShape(center + scale * random.inBall(), 0.2 * scale, random));
        } else {
            const glm::dvec3 place = center + crowd.size * random.inBall();
            shapes.push_back(randomShape(place, spacing, random));
        }
    }
    return shapes;
}

/// From in and around the crowd; every third one along an axis, some at points of the shapes.
Ray makeRay(const Crowd& crowd, const glm::dvec3& center, RandomNumbers& random) {
    glm::dvec3 direction = random.direction();
    if (random.below(3) == 0) {
        direction = glm::dvec3(random.coin() ? 0.0 : -0.0);
        direction[static_cast<int>(random.below(3))] = random.sign();
    }
    const double scale = crowd.arrangement == Arrangement::Clustered
                             ? crowd.size * random.powerOfTen(-20.0, 0.0)
                             : crowd.size;
    const glm::dvec3 target = center + scale * random.inBall();
    return {target - scale * random.powerOfTen(-1.0, 3.0) * direction, direction};
}

class ReferenceTreeTest : public testing::TestWithParam<Crowd> {};

TEST_P(ReferenceTreeTest, FindsWhatBruteForceFinds) {
    constexpr uint32_t kTests = 2'000'000; // of primitives against rays
    const Crowd& crowd = GetParam();
    RandomNumbers random(31);
    const glm::dvec3 center = crowd.size * crowd.distance * random.direction();
    const std::vector<Shape> shapes = makeCrowd(crowd, center, random);
    const Scene scene = sceneOf(shapes);
    const Geometry geometry(scene);
    std::vector<Scene> scenes;
    for (const Shape& shape : shapes)
        scenes.push_back(sceneOf({shape}));
    std::vector<Geometry> alone;
    for (const Scene& one : scenes)
        alone.emplace_back(one);

    uint32_t hits = 0;
    for (uint32_t i = 0; i < std::min(20'000u, kTests / crowd.count); ++i) {
        const Ray ray = makeRay(crowd, center, random);
        std::optional<reference::Hit> expected;
        for (uint32_t number = 0; number < alone.size(); ++number) {
            const auto hit = alone[number].closest(ray);
            if (hit && (!expected || hit->t < expected->t))
                expected = reference::Hit{hit->t, number};
        }
        const auto found = geometry.closest(ray);
        ASSERT_EQ(found.has_value(), expected.has_value()) << "ray " << i;
        if (!found)
            continue;
        ++hits;
        ASSERT_EQ(found->t, expected->t) << "ray " << i;
        ASSERT_EQ(found->primitive, expected->primitive) << "ray " << i;
    }
    EXPECT_GT(hits, 100u);
}

INSTANTIATE_TEST_SUITE_P(Of, ReferenceTreeTest,
                         testing::Values(Crowd{"One", 1, Arrangement::Scattered},
                                         Crowd{"Two", 2, Arrangement::Scattered},
                                         Crowd{"Five", 5, Arrangement::Scattered},
                                         Crowd{"Hundred", 100, Arrangement::Scattered},
                                         Crowd{"TwoThousand", 2000, Arrangement::Scattered},
                                         Crowd{"TinyMoved", 500, Arrangement::Scattered, 1e-6, 1e6},
                                         Crowd{"HugeMoved", 500, Arrangement::Scattered, 1e6, 1e6},
                                         Crowd{"Clusters", 500, Arrangement::Clustered},
                                         Crowd{"Coincident", 300, Arrangement::Coincident}),
                         [](const auto& instance) { return instance.param.name; });

TEST(ReferenceTreeDepthTest, IsBoundedForBoxesThatShrinkForever) {
    // Cuts at the middle would take one box off at a time, two thousand levels deep.
    std::vector<Shape> shapes;
    for (int power = -1000; power < 30; ++power) {
        const double x = std::ldexp(1.0, power);
        shapes.push_back(shapeOf(Sphere{{glm::dmat3(1.0), {x, 0.0, 0.0}}, 0.1 * x}));
        shapes.push_back(shapeOf(Sphere{{glm::dmat3(1.0), {-x, 0.0, 0.0}}, 0.1 * x}));
    }
    const Scene scene = sceneOf(shapes);
    const Geometry geometry(scene);
    for (uint32_t i = 2 * 970; i < shapes.size(); ++i) { // from 2^-30 on
        const Sphere& sphere = std::get<Sphere>(shapes[i].geometry);
        const glm::dvec3 center = sphere.worldFromObject.translation;
        const auto hit = geometry.closest({center + glm::dvec3(0.0, 1.0, 0.0), {0.0, -1.0, 0.0}});
        ASSERT_TRUE(hit);
        ASSERT_EQ(hit->primitive, i);
    }
}

TEST(ReferenceTreeDepthTest, IsBoundedForBoxesInOnePlace) {
    const Scene scene = sceneOf(std::vector<Shape>(10'000, shapeOf(Sphere{})));
    const auto hit = Geometry(scene).closest({{0.0, 0.0, 3.0}, {0.0, 0.0, -1.0}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 2.0);
    EXPECT_EQ(hit->primitive, 0u);
}

} // namespace
} // namespace calotype::test
