// Triangles sampled by their solid angle, against solid angles known in closed form and Girard's
// theorem.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "reference/spherical_triangle.h"
#include "support/chi_square.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

using reference::SeenTriangle;

constexpr double kPi = std::numbers::pi;

/// The sum of the angles between the planes of its sides, less pi (Girard 1626).
double girardsExcess(const SeenTriangle& seen) {
    const std::array corners = {seen.a, seen.b, seen.c};
    double sum = -kPi;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 first = glm::cross(corners[i], corners[(i + 1) % 3]);
        const glm::dvec3 second = glm::cross(corners[i], corners[(i + 2) % 3]);
        sum += std::acos(glm::dot(glm::normalize(first), glm::normalize(second)));
    }
    return sum;
}

/// Near, wide, seen askew, and from a point very close to its inside.
const SeenTriangle kTriangles[] = {
    {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}},
    {{-0.8, 0.05, 0.6}, {1.1, 0.05, 0.5}, {0.1, 0.05, -1.3}},
    {{0.2, 1.0, 0.3}, {1.4, 0.4, 0.2}, {0.3, 0.3, 2.0}},
    {{-1.0, 0.2, 1.0}, {1.0, 0.2, 1.0}, {0.0, 0.2, 0.9}},
    {{0.3, -0.1, 0.2}, {-1.0, 0.1, 0.5}, {0.9, 0.2, 1.5}},
};

TEST(SphericalTriangleTest, SeesAnOctantAndTheSidesOfATetrahedron) {
    EXPECT_NEAR((SeenTriangle{{7, 0, 0}, {0, 2, 0}, {0, 0, 3}}).solidAngle(), 0.5 * kPi, 1e-14);
    EXPECT_NEAR((SeenTriangle{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}}).solidAngle(), kPi, 1e-14);
    // Seen from far ahead of it, its area over the square of the distance.
    EXPECT_NEAR((SeenTriangle{{0, 1e5, 0}, {1, 1e5, 0}, {0, 1e5, 1}}).solidAngle(), 0.5e-10, 1e-19);
    // From its own plane, and from inside of it.
    EXPECT_EQ((SeenTriangle{{1, 0, 1}, {2, 0, 1}, {1, 0, 2}}).solidAngle(), 0.0);
    EXPECT_NEAR((SeenTriangle{{1, 0, -1}, {-1, 0, -1}, {0, 0, 1}}).solidAngle(), 2.0 * kPi, 1e-14);
}

TEST(SphericalTriangleTest, SolidAngleIsGirardsExcess) {
    for (const SeenTriangle& seen : kTriangles)
        EXPECT_NEAR(seen.solidAngle(), girardsExcess(seen), 1e-13);
}

/// The weights of the corners of the triangle's plane in the direction w.
glm::dvec3 barycentrics(const SeenTriangle& seen, const glm::dvec3& w) {
    const glm::dvec3 weights(glm::dot(w, glm::cross(seen.b, seen.c)),
                             glm::dot(w, glm::cross(seen.c, seen.a)),
                             glm::dot(w, glm::cross(seen.a, seen.b)));
    return weights / (weights.x + weights.y + weights.z);
}

// The triangle is cut into 64 in its plane, of very different solid angles.
TEST(SphericalTriangleTest, DirectionsAreUniform) {
    constexpr int kRows = 8;
    constexpr int kSamples = 200'000;
    for (const SeenTriangle& seen : kTriangles) {
        const auto corner = [&](int i, int j) {
            return seen.a +
                   (double(i) * (seen.b - seen.a) + double(j) * (seen.c - seen.a)) / double(kRows);
        };
        std::array<double, kRows * kRows * 2> chances{};
        for (int i = 0; i < kRows; ++i)
            for (int j = 0; i + j < kRows; ++j) {
                const size_t cell = 2 * (i * kRows + j);
                chances[cell] = girardsExcess({corner(i, j), corner(i + 1, j), corner(i, j + 1)});
                if (i + j < kRows - 1)
                    chances[cell + 1] =
                        girardsExcess({corner(i + 1, j + 1), corner(i + 1, j), corner(i, j + 1)});
            }
        std::array<uint64_t, kRows * kRows * 2> counts{};
        RandomNumbers random(213);
        for (int n = 0; n < kSamples; ++n) {
            const glm::dvec3 w = seen.direction({random.unit(), random.unit()});
            ASSERT_NEAR(glm::length(w), 1.0, 1e-12);
            const glm::dvec3 b = barycentrics(seen, w);
            ASSERT_GT(std::min({b.x, b.y, b.z}), -1e-9);
            const glm::dvec2 place = double(kRows) * glm::max(glm::dvec2(b.y, b.z), 0.0);
            const int i = std::min(int(place.x), kRows - 1);
            const int j = std::min(int(place.y), kRows - 1 - i);
            const bool isUpper = place.x - i + place.y - j > 1.0 && i + j < kRows - 1;
            ++counts[2 * (i * kRows + j) + (isUpper ? 1 : 0)];
        }
        std::vector<double> kept;
        std::vector<uint64_t> keptCounts;
        for (size_t cell = 0; cell < chances.size(); ++cell)
            if (chances[cell] > 0.0) {
                kept.push_back(chances[cell] / seen.solidAngle());
                keptCounts.push_back(counts[cell]);
            }
        EXPECT_EQ(kept.size(), size_t(kRows * kRows));
        EXPECT_GT(*std::ranges::min_element(kept) * kSamples, 10.0);
        EXPECT_LT(chiSquare(keptCounts, kept), chiSquareLimit(kept.size() - 1));
    }
}

// u.y moves along the edge from b to c, u.x from a to that edge; so it is where the triangle is
// far.
TEST(SphericalTriangleTest, EndsOfTheNumbersAreCornersAndEdges) {
    for (const SeenTriangle& seen : kTriangles) {
        const auto expectAt = [&](const glm::dvec2& u, const glm::dvec3& corner) {
            EXPECT_LT(glm::length(seen.direction(u) - glm::normalize(corner)), 1e-7) << u.x << u.y;
        };
        expectAt({0.0, 0.3}, seen.a);
        expectAt({1.0, 0.0}, seen.b);
        expectAt({1.0, 1.0}, seen.c);
    }
    const glm::dvec3 away(2e4, 5e4, 1e4);
    const SeenTriangle far{away, away + glm::dvec3(1, 0, 0), away + glm::dvec3(0, 0, 1)};
    for (const glm::dvec2& u : {glm::dvec2(0.2, 0.7), glm::dvec2(0.9, 0.4)}) {
        const glm::dvec3 b = barycentrics(far, far.direction(u));
        EXPECT_NEAR(b.y, std::sqrt(u.x) * (1.0 - u.y), 1e-4);
        EXPECT_NEAR(b.z, std::sqrt(u.x) * u.y, 1e-4);
    }
}

} // namespace
} // namespace calotype::test
