// Normals by normal maps, and shading normals bent to agree with the true surface.
#include <cmath>

#include <glm/geometric.hpp>

#include "kernels/shading_normal.spv.h"
#include "support/gpu_test.h"
#include "support/kernels/test_structs.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

/// Some operations on unit vectors.
constexpr double kRounding = 1e-6;

const glm::vec3 kFlat(0.5f, 0.5f, 1.0f);

/// A unit vector within a right angle of another one.
glm::dvec3 onSideOf(const glm::dvec3& normal, RandomNumbers& random) {
    const glm::dvec3 w = random.direction();
    return glm::dot(w, normal) < 0.0 ? -w : w;
}

/// Unit vectors at `height` above the surface.
glm::dvec3 atHeight(double height, const glm::dvec3& normal, RandomNumbers& random) {
    const glm::dvec3 along = glm::normalize(glm::cross(normal, random.direction()));
    return std::sqrt(1.0 - height * height) * along + height * normal;
}

/// A surface whose interpolated normal leans as far from the true one as `lean` (sine), and whose
/// texture coordinates are sheared and of either handedness.
shared::TestNormalMap randomSurface(double lean, RandomNumbers& random) {
    const glm::dvec3 ng = random.direction();
    const glm::dvec3 n = glm::normalize(ng + lean * random.inBall());
    const double length = random.powerOfTen(-4.0, 4.0);
    const glm::dvec3 u = glm::normalize(glm::cross(ng, random.direction()));
    const glm::dvec3 v = random.sign() * glm::cross(ng, u) + random.between(-1.0, 1.0) * u;
    shared::TestNormalMap surface{};
    surface.ng = glm::vec3(ng);
    surface.n = glm::vec3(n);
    surface.dpdu = glm::vec3(length * u);
    surface.dpdv = glm::vec3(length * random.between(0.1, 10.0) * v);
    surface.wo = glm::vec3(onSideOf(ng, random));
    surface.texel = kFlat;
    return surface;
}

/// The format's frame T, B, N and 2 c - 1 in it, mirrored where it leaves the true surface's side.
glm::dvec3 oracleMapped(const shared::TestNormalMap& surface) {
    const glm::dvec3 n(surface.n);
    const glm::dvec3 ng(surface.ng);
    const glm::dvec3 dpdu(surface.dpdu);
    const glm::dvec3 t = glm::normalize(dpdu - n * glm::dot(n, dpdu) / glm::dot(n, n));
    const double handedness =
        std::copysign(1.0, glm::dot(glm::cross(n, t), glm::dvec3(surface.dpdv)));
    const glm::dvec3 c = 2.0 * glm::dvec3(surface.texel) - 1.0;
    const glm::dvec3 mapped = c.x * t + handedness * c.y * glm::cross(n, t) + c.z * n;
    return glm::normalize(glm::dot(mapped, ng) < 0.0 ? glm::reflect(mapped, ng) : mapped);
}

class ShadingNormalTest : public GpuTest {
protected:
    std::vector<shared::TestNormals> run(const std::vector<shared::TestNormalMap>& queries) {
        return runKernel<shared::TestNormals>(kShadingNormalSpirv, queries);
    }
};

TEST_F(ShadingNormalTest, OfAFlatMapIsTheSurfaces) {
    RandomNumbers random(141);
    std::vector<shared::TestNormalMap> queries;
    for (int i = 0; i < 10'000; ++i)
        queries.push_back(randomSurface(0.9, random));
    const auto results = run(queries);
    for (size_t i = 0; i < queries.size(); ++i)
        ASSERT_LT(glm::length(glm::dvec3(results[i].mapped) - glm::dvec3(queries[i].n)), kRounding);
}

// Red tilts it to where u grows and no way else, green to where v grows, whatever the handedness.
TEST_F(ShadingNormalTest, TiltsToWhereTheCoordinatesGrow) {
    RandomNumbers random(142);
    std::vector<shared::TestNormalMap> queries;
    for (int i = 0; i < 10'000; ++i) {
        queries.push_back(randomSurface(0.2, random));
        const double tilt = random.sign() * random.between(0.05, 0.3);
        queries.back().texel[i % 2] += static_cast<float>(tilt);
    }
    const auto results = run(queries);
    for (size_t i = 0; i < queries.size(); ++i) {
        const shared::TestNormalMap& query = queries[i];
        const glm::dvec3 n(query.n);
        const glm::dvec3 mapped(results[i].mapped);
        const glm::dvec3 u =
            glm::normalize(glm::dvec3(query.dpdu) - glm::dot(glm::dvec3(query.dpdu), n) * n);
        // The part of v's direction that is perpendicular to u and n.
        const glm::dvec3 v(query.dpdv);
        const glm::dvec3 across = glm::normalize(v - glm::dot(v, n) * n - glm::dot(v, u) * u);
        const double slope = 2.0 * query.texel[i % 2] - 1.0;
        const double sine = slope / std::hypot(slope, 1.0);
        ASSERT_NEAR(glm::dot(mapped, u), i % 2 == 0 ? sine : 0.0, kRounding);
        ASSERT_NEAR(glm::dot(mapped, across), i % 2 == 1 ? sine : 0.0, kRounding);
    }
}

TEST_F(ShadingNormalTest, OfAnyMapIsTheFormatsAndUnitAndOnTheTrueSide) {
    RandomNumbers random(143);
    std::vector<shared::TestNormalMap> queries;
    for (int i = 0; i < 50'000; ++i) {
        queries.push_back(randomSurface(0.9, random));
        queries.back().texel = glm::vec3(random.unit(), random.unit(), random.unit());
    }
    const auto results = run(queries);
    for (size_t i = 0; i < queries.size(); ++i) {
        const glm::dvec3 mapped(results[i].mapped);
        const glm::dvec3 c = 2.0 * glm::dvec3(queries[i].texel) - 1.0;
        ASSERT_NEAR(glm::length(mapped), 1.0, kRounding);
        ASSERT_GE(glm::dot(mapped, glm::dvec3(queries[i].ng)), -kRounding);
        // The texel's direction is the less sure the shorter its vector.
        ASSERT_LT(glm::length(mapped - oracleMapped(queries[i])), 4.0 * kRounding / glm::length(c));
    }
}

TEST_F(ShadingNormalTest, IsTheSurfacesWhereTheMapOrItsFrameSaysNothing) {
    RandomNumbers random(144);
    std::vector<shared::TestNormalMap> queries;
    for (int i = 0; i < 100; ++i) {
        queries.push_back(randomSurface(0.5, random)); // no direction
        queries.back().texel = glm::vec3(0.5f);
        queries.push_back(randomSurface(0.5, random)); // no coordinates
        queries.back().texel = glm::vec3(0.9f, 0.2f, 0.8f);
        queries.back().dpdu = queries.back().dpdv = glm::vec3(0.0f);
    }
    const auto results = run(queries);
    for (size_t i = 0; i < queries.size(); ++i)
        EXPECT_EQ(results[i].mapped, queries[i].n);
}

// u along the normal, v along u, and lengths at the ends of float's range.
TEST_F(ShadingNormalTest, IsUnitForDirectionsThatAreNoFrame) {
    RandomNumbers random(145);
    std::vector<shared::TestNormalMap> queries;
    for (int i = 0; i < 1000; ++i) {
        shared::TestNormalMap query = randomSurface(0.5, random);
        query.texel = glm::vec3(random.unit(), random.unit(), random.unit());
        if (i % 4 == 0)
            query.dpdu = query.n;
        if (i % 4 == 1)
            query.dpdv = query.dpdu;
        if (i % 4 == 2)
            query.dpdu *= 1e15f, query.dpdv *= 1e15f;
        if (i % 4 == 3)
            query.dpdu *= 1e-25f, query.dpdv *= 1e-25f;
        queries.push_back(query);
    }
    for (const shared::TestNormals& result : run(queries))
        ASSERT_NEAR(glm::length(glm::dvec3(result.mapped)), 1.0, kRounding);
}

// However steep the view and the normal, down to views along the surface and to mirrored viewers
// straight beneath it. The last lose digits: what is left of them after the lift is short.
TEST_F(ShadingNormalTest, IsBentUntilTheMirroredViewerIsAboveTheSurface) {
    RandomNumbers random(146);
    std::vector<shared::TestNormalMap> queries;
    for (int i = 0; i < 200'000; ++i) {
        queries.push_back(randomSurface(0.0, random));
        const glm::dvec3 ng(queries.back().ng);
        const double height = i % 2 == 0 ? random.unit() : random.powerOfTen(-9.0, -1.0);
        const glm::dvec3 wo = atHeight(height, ng, random);
        const double lean = random.powerOfTen(-7.0, -0.01);
        const glm::dvec3 normals[] = {
            ng, atHeight(lean, ng, random), glm::normalize(atHeight(lean, ng, random) + 0.01 * wo),
            glm::normalize(ng - wo + std::pow(lean, 3.0) * random.direction())};
        queries.back().wo = glm::vec3(wo);
        const glm::dvec3 n = normals[i / 2 % 4];
        queries.back().n = glm::vec3(glm::dot(n, ng) < 0.0 ? -n : n);
    }
    const auto results = run(queries);
    int identical = 0;
    int bent = 0;
    for (size_t i = 0; i < queries.size(); ++i) {
        const glm::dvec3 wo(queries[i].wo);
        const glm::dvec3 ng(queries[i].ng);
        const glm::dvec3 ns(queries[i].n);
        const glm::dvec3 result(results[i].consistent);
        const double lowest = 0.02 * glm::dot(wo, ng);
        const double before = glm::dot(glm::reflect(-wo, ns), ng);
        const double after = glm::dot(glm::reflect(-wo, result), ng);
        const double left = std::sqrt(std::max(1.0 - before * before, 1e-4));
        const double rounding = 4.0 * kRounding / left; // of a dozen more operations
        ASSERT_NEAR(glm::length(result), 1.0, kRounding) << "viewer at " << glm::dot(wo, ng);
        ASSERT_GT(glm::dot(result, ng), -rounding);
        ASSERT_GE(after, lowest - rounding);
        if (before > lowest + 4.0 * kRounding) {
            ++identical;
            ASSERT_EQ(results[i].consistent, queries[i].n);
        } else if (before < lowest - kRounding && left > 0.02) {
            ++bent; // no further than needed
            ASSERT_LE(after, lowest / left * (1.0 + rounding / left) + rounding);
            ASSERT_GT(glm::dot(wo, result), -rounding);
        }
    }
    EXPECT_GT(std::min(identical, bent), 20'000);
}

} // namespace
} // namespace calotype::test
