// Where light leaves a triangle with smooth normals.
#include <cmath>

#include <glm/geometric.hpp>

#include "kernels/terminator.spv.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/kernels/test_structs.h"
#include "support/random_numbers.h"
#include "support/test_quadrics.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

/// A triangle's corners and their normals, in double.
struct SmoothTriangle {
    glm::dvec3 corners[3];
    glm::dvec3 normals[3];

    glm::dvec3 faceNormal() const {
        return glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    }
    glm::dvec3 middle() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
    /// To which the roundings of a point are relative.
    double reach() const { return glm::length(corners[0]) + glm::length(corners[1] - corners[0]); }
};

shared::TestSmoothPoint pointOf(const SmoothTriangle& triangle, const glm::dvec2& b, double side) {
    shared::TestSmoothPoint point{};
    point.triangle.v0 = glm::vec3(triangle.corners[0]);
    point.triangle.v1 = glm::vec3(triangle.corners[1]);
    point.triangle.v2 = glm::vec3(triangle.corners[2]);
    point.normals.n0 = glm::vec3(triangle.normals[0]);
    point.normals.n1 = glm::vec3(triangle.normals[1]);
    point.normals.n2 = glm::vec3(triangle.normals[2]);
    point.position = glm::vec3((1.0 - b.x - b.y) * triangle.corners[0] + b.x * triangle.corners[1] +
                               b.y * triangle.corners[2]);
    point.barycentrics = glm::vec2(b);
    point.side = static_cast<float>(side);
    return point;
}

/// Uniform on a triangle.
glm::dvec2 randomBarycentrics(RandomNumbers& random) {
    const double root = std::sqrt(random.unit());
    const double share = random.unit();
    return {root * (1.0 - share), root * share};
}

/// An equilateral triangle somewhere, whose normals lean outward by `lean` (negative: inward).
SmoothTriangle leaningTriangle(double lean, RandomNumbers& random) {
    const glm::dmat3 frame = randomRotation(random);
    const glm::dvec3 center = 2.0 * random.inBall();
    const double size = random.powerOfTen(-1.0, 1.0);
    SmoothTriangle triangle;
    for (int k = 0; k < 3; ++k) {
        const double angle = 2.0 * std::numbers::pi / 3.0 * k;
        const glm::dvec3 outward = std::cos(angle) * frame[0] - std::sin(angle) * frame[2];
        triangle.corners[k] = center + size * outward;
        triangle.normals[k] = glm::normalize(frame[1] + lean * outward);
    }
    return triangle;
}

/// The triangles of a sphere about the origin with the sphere's normals.
std::vector<SmoothTriangle> sphereTriangles(uint32_t level, double radius) {
    const Mesh mesh = icosphere(level, glm::dvec3(0.0), radius);
    std::vector<SmoothTriangle> triangles;
    for (const Mesh::Triangle& source : mesh.triangles) {
        SmoothTriangle triangle;
        for (int k = 0; k < 3; ++k) {
            triangle.corners[k] = mesh.positions[source.position[k]];
            triangle.normals[k] = glm::normalize(triangle.corners[k]);
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

class TerminatorOffsetTest : public GpuTest {
protected:
    std::vector<glm::dvec3> run(const std::vector<shared::TestSmoothPoint>& points) {
        std::vector<glm::dvec3> offsets;
        for (const glm::vec4& offset : runKernel<glm::vec4>(kTerminatorSpirv, points))
            offsets.emplace_back(offset);
        return offsets;
    }
};

// But for the rounding of the point, which may put it a little beneath its plane.
TEST_F(TerminatorOffsetTest, IsZeroWhereTheSurfaceIsFlatOrConcave) {
    RandomNumbers random(171);
    std::vector<shared::TestSmoothPoint> points;
    std::vector<double> reaches;
    for (int i = 0; i < 20'000; ++i) {
        const double lean = i % 2 == 0 ? 0.0 : random.between(0.0, 0.8);
        // Seen from behind, what bulges is hollow.
        const double side = random.sign();
        const SmoothTriangle triangle = leaningTriangle(-side * lean, random);
        points.push_back(pointOf(triangle, randomBarycentrics(random), side));
        reaches.push_back(triangle.reach());
    }
    const auto offsets = run(points);
    for (size_t i = 0; i < offsets.size(); ++i)
        ASSERT_LT(glm::length(offsets[i]), 4.0 * kRoundoffOfFloat * reaches[i]);
}

TEST_F(TerminatorOffsetTest, IsZeroAtTheCornersAndTowardsTheLightBetween) {
    RandomNumbers random(172);
    std::vector<shared::TestSmoothPoint> points;
    std::vector<glm::dvec3> normals;
    for (int i = 0; i < 4000; ++i) {
        const double side = random.sign();
        const SmoothTriangle triangle = leaningTriangle(side * random.between(0.1, 0.8), random);
        const glm::dvec2 corners[] = {{0, 0}, {1, 0}, {0, 1}};
        const bool isCorner = i % 2 == 0;
        points.push_back(
            pointOf(triangle, isCorner ? corners[i / 2 % 3] : glm::dvec2(1.0 / 3.0), side));
        normals.push_back(side * triangle.faceNormal());
    }
    const auto offsets = run(points);
    for (size_t i = 0; i < offsets.size(); ++i)
        if (i % 2 == 0)
            ASSERT_EQ(offsets[i], glm::dvec3(0.0));
        else
            ASSERT_GT(glm::dot(offsets[i], normals[i]), 1e-3);
}

// On a sphere of radius r let Q be the sum of b_i b_j e_ij^2 over the three edges e_ij / r. Then
// the point p has |p|^2 = r^2 (1 - Q), and the patch over it, r^2 (1 + Q - W / 2 + |w|^2 / 4),
// where W is the mean of s_i^2, w that of s_i n_i, s_i the sum of b_j e_ij^2, and 2 Q the mean of
// s_i. As |w|^2 <= W <= 2 Q max s_i, and edges are shorter than r, it lies outside the sphere, but
// no further in squares than p lies inside.
TEST_F(TerminatorOffsetTest, BringsThePointOntoTheOutsideOfASphere) {
    RandomNumbers random(173);
    for (const double radius : {1e-3, 1.0, 50.0})
        for (const uint32_t level : {1u, 2u, 3u}) {
            std::vector<shared::TestSmoothPoint> points;
            for (const SmoothTriangle& triangle : sphereTriangles(level, radius))
                for (int i = 0; i < 20; ++i)
                    points.push_back(pointOf(triangle, randomBarycentrics(random), 1.0));
            const auto offsets = run(points);
            for (size_t i = 0; i < points.size(); ++i) {
                const glm::dvec3 p = glm::dvec3(points[i].position) / radius;
                const glm::dvec3 patch = p + offsets[i] / radius;
                constexpr double kTolerance = 8.0 * kRoundoffOfFloat;
                ASSERT_GE(glm::dot(patch, patch), 1.0 - kTolerance);
                ASSERT_LE(glm::dot(patch, patch) - 1.0, 1.0 - glm::dot(p, p) + kTolerance);
            }
        }
}

TEST_F(TerminatorOffsetTest, IsZeroOnATriangleWithoutNormalsAndFiniteOnOneWithoutArea) {
    RandomNumbers random(174);
    std::vector<shared::TestSmoothPoint> points;
    for (int i = 0; i < 1000; ++i) {
        SmoothTriangle triangle = leaningTriangle(0.5, random);
        for (int k = 0; k < 3; ++k) {
            triangle.corners[k] = i % 2 == 0 ? triangle.corners[k] : triangle.corners[0];
            triangle.normals[k] = i % 2 == 0 ? glm::dvec3(0.0) : random.direction();
        }
        points.push_back(pointOf(triangle, randomBarycentrics(random), random.sign()));
    }
    const auto offsets = run(points);
    for (size_t i = 0; i < offsets.size(); ++i) {
        if (i % 2 == 0)
            ASSERT_EQ(offsets[i], glm::dvec3(0.0));
        ASSERT_LT(glm::length(offsets[i]), 1e-5);
    }
}

} // namespace
} // namespace calotype::test
