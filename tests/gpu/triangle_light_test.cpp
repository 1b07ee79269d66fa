// Triangle lights on the device against the reference's spherical trigonometry in double precision,
// from the same random numbers.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "kernels/light_sample.spv.h"
#include "reference/spherical_triangle.h"
#include "render/scene_buffers.h"
#include "support/gpu_test.h"
#include "support/kernels/test_structs.h"
#include "support/random_numbers.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

constexpr uint32_t kTriangles = 2000;
constexpr uint32_t kNone = Mesh::kNoNormal;
constexpr double kRoundoff = 0x1p-23;
constexpr double kLargestSolidAngle = 2.0 * std::numbers::pi - 1.0 / 16.0;

/// A triangle light, and the sample that the device took from a point.
struct TriangleSample {
    reference::SeenTriangle seen;
    glm::dvec3 normal;
    glm::dvec2 u;
    glm::dvec3 toPoint; ///< from the shading point
    double pdf;
};

/// Where the point is above which the shading points are.
enum class Above { Inside, Edge, Corner };

class TriangleLightTest : public GpuTest {
protected:
    /// Triangles of about the size 1; the shading points have that distance from them.
    static std::vector<TriangleSample> samplesFrom(Above above, double distance) {
        RandomNumbers random(51);
        Mesh mesh;
        std::vector<glm::dvec3> shadingPoints;
        for (uint32_t i = 0; i < kTriangles; ++i) {
            const std::vector<glm::dvec3> corners = wideTriangle(random);
            mesh.triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, {kNone, kNone, kNone}, 0});
            mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
            shadingPoints.push_back(pointAbove(random, corners, above, distance));
        }
        Scene scene = sceneOf({shapeOf(std::move(mesh))});
        scene.materials[0].emission = glm::dvec3(1.0);
        GpuScene packed = packAsProgram(scene).packed;
        for (shared::Light& light : packed.lights) // also though each is rarely chosen
            light.flags |= shared::kLightBySolidAngle;
        return sampled(packed, shadingPoints, random);
    }

private:
    static std::vector<glm::dvec3> wideTriangle(RandomNumbers& random) {
        const glm::dvec3 first = random.inBall();
        const glm::dvec3 along = random.direction();
        const glm::dvec3 across = glm::normalize(glm::cross(along, random.direction()));
        return {first, first + along,
                first + random.between(-0.5, 1.5) * along + random.between(0.3, 1.0) * across};
    }

    static glm::dvec3 pointAbove(RandomNumbers& random, const std::vector<glm::dvec3>& corners,
                                 Above above, double distance) {
        const glm::dvec3 ab = corners[1] - corners[0];
        const glm::dvec3 ac = corners[2] - corners[0];
        const glm::dvec3 normal = glm::normalize(glm::cross(ab, ac));
        const uint32_t corner = random.below(3);
        const double along = random.between(0.1, 0.9);
        glm::dvec3 base = corners[corner];
        if (above == Above::Edge)
            base += along * (corners[(corner + 1) % 3] - base);
        if (above == Above::Inside) // no nearer than a third of the height to an edge
            base = corners[0] + (ab + ac) / 3.0;
        const glm::dvec3 away = glm::normalize(random.inBall() + 2.0 * random.sign() * normal);
        return base + distance * (above == Above::Inside ? random.sign() * normal : away);
    }

    static std::vector<TriangleSample> sampled(const GpuScene& packed,
                                               const std::vector<glm::dvec3>& shadingPoints,
                                               RandomNumbers& random) {
        std::vector<shared::TestLightQuery> queries;
        std::vector<TriangleSample> samples;
        for (uint32_t i = 0; i < kTriangles; ++i) {
            const shared::Triangle& t = packed.triangles[packed.lights[i].primitive];
            const glm::vec3 from(shadingPoints[t.id] - packed.origin);
            const glm::vec2 u(random.deviceUnit(), random.deviceUnit());
            queries.push_back({from, i, {u.x, u.y, 0.0f, 0.0f}, 1, 0, 0, 0});
            const glm::dvec3 x(from);
            const reference::SeenTriangle seen{glm::dvec3(t.v0) - x, glm::dvec3(t.v1) - x,
                                               glm::dvec3(t.v2) - x};
            const glm::dvec3 normal = glm::normalize(glm::cross(seen.b - seen.a, seen.c - seen.a));
            samples.push_back({seen, normal, glm::dvec2(u), {}, 0.0});
        }
        const SceneBuffers buffers(testDevice(), packed);
        const auto results = runKernel<shared::TestLightSample>(
            kLightSampleSpirv, queries, buffers.bindings(), kTestInputBinding);
        for (uint32_t i = 0; i < kTriangles; ++i) {
            samples[i].toPoint =
                glm::dvec3(results[i].position) - glm::dvec3(queries[i].shadingPoint);
            samples[i].pdf = results[i].pdf;
            EXPECT_EQ(results[i].pdf, results[i].pdfOfHit);
        }
        return samples;
    }
};

/// Rounding of the directions to the corners moves what is near them in the proportion of the
/// distance: where the plane or an edge is a hundredth of the triangle's size away, by 100 times as
/// much. 8 roundings; 1 was seen.
double boundAt(double distance) { return 8.0 * kRoundoff * (1.0 + 1.0 / distance); }

void expectSampledBySolidAngle(const std::vector<TriangleSample>& samples, double distance) {
    uint32_t bySolidAngle = 0;
    double worstPdf = 0.0;
    double worstPoint = 0.0;
    for (const TriangleSample& sample : samples) {
        const double solidAngle = sample.seen.solidAngle();
        if (solidAngle > kLargestSolidAngle - 1e-4)
            continue;
        ++bySolidAngle;
        worstPdf = std::max(worstPdf, std::abs(sample.pdf * solidAngle - 1.0));
        const glm::dvec3 wi = sample.seen.direction(sample.u);
        const double t = glm::dot(sample.seen.a, sample.normal) / glm::dot(wi, sample.normal);
        worstPoint = std::max(worstPoint, glm::length(sample.toPoint - t * wi));
    }
    std::cout << "at " << distance << ": density off by " << worstPdf << ", point by " << worstPoint
              << " of " << boundAt(distance) << "\n";
    EXPECT_GT(bySolidAngle, kTriangles / 4);
    EXPECT_LT(worstPdf, boundAt(distance));
    EXPECT_LT(worstPoint, boundAt(distance));
}

TEST_F(TriangleLightTest, IsSampledAsByTheReferenceAboveItsInside) {
    for (const double distance : {0.02, 0.1, 1.0, 100.0, 1e4})
        expectSampledBySolidAngle(samplesFrom(Above::Inside, distance), distance);
}

TEST_F(TriangleLightTest, IsSampledAsByTheReferenceAboveItsEdges) {
    for (const double distance : {0.01, 0.1, 1.0})
        expectSampledBySolidAngle(samplesFrom(Above::Edge, distance), distance);
}

TEST_F(TriangleLightTest, IsSampledAsByTheReferenceAboveItsCorners) {
    for (const double distance : {1e-4, 0.01, 1.0})
        expectSampledBySolidAngle(samplesFrom(Above::Corner, distance), distance);
}

// Very close, and from where it is but a point, the density is that of a uniform point.
TEST_F(TriangleLightTest, IsSampledByAreaWhereSinglePrecisionRequiresIt) {
    for (const double distance : {1e-4, 1e-3, 1e8}) {
        uint32_t byArea = 0;
        for (const TriangleSample& sample : samplesFrom(Above::Inside, distance)) {
            if (sample.seen.isSampledBySolidAngle())
                continue;
            ++byArea;
            const double area = 0.5 * glm::length(glm::cross(sample.seen.b - sample.seen.a,
                                                             sample.seen.c - sample.seen.a));
            const double d2 = glm::dot(sample.toPoint, sample.toPoint);
            const double cosTheta = std::abs(glm::dot(sample.toPoint, sample.normal)) / sqrt(d2);
            EXPECT_NEAR(sample.pdf * area * cosTheta / d2, 1.0, boundAt(distance));
        }
        EXPECT_GT(byArea, kTriangles * 9 / 10);
    }
}

} // namespace
} // namespace calotype::test
