#include <numbers>

#include <glm/geometric.hpp>

#include "kernels/light_sample.spv.h"
#include "math/rotation.h"
#include "render/scene_buffers.h"
#include "support/gpu_test.h"
#include "support/kernels/test_structs.h"
#include "support/oracle_quadric.h"
#include "support/oracle_triangle.h"
#include "support/random_numbers.h"
#include "support/statistics.h"
#include "support/test_quadrics.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

constexpr uint32_t kSamples = 100'000;
constexpr uint32_t kOracleRays = 400'000;
const glm::vec3 kRadiance(3.0f, 2.0f, 1.0f);

/// A light alone in its scene, and a point that it lights.
struct LightCase {
    std::string name;
    Shape shape;
    glm::dvec3 shadingPoint;
};

RigidTransform tilted() {
    RandomNumbers random(31);
    return {randomRotation(random), {0.3, -0.2, 0.5}};
}

glm::dvec3 seen(double x, double y, double z) { return tilted().point({x, y, z}); }

std::vector<LightCase> lightCases() {
    const RigidTransform frame = tilted();
    const auto triangle = [&] {
        return singleTriangle(seen(0, 0, 0), seen(1, 0, 0), seen(0.3, 0, 0.8));
    };
    std::vector<LightCase> cases;
    const auto add = [&](const std::string& name, auto shape, const glm::dvec3& shadingPoint) {
        cases.push_back({name, shapeOf(std::move(shape), 1), shadingPoint});
    };
    add("TriangleNear", triangle(), seen(0.4, 0.2, 0.3));
    add("TriangleFar", triangle(), seen(30.0, 40.0, -20.0));
    add("TriangleBehind", triangle(), seen(0.2, -1.0, 0.2));
    add("TriangleClose", triangle(), seen(0.4, 0.02, 0.3));
    add("TriangleVeryClose", triangle(), seen(0.4, 0.001, 0.3));
    add("TriangleBesideItsEdge", triangle(), seen(0.5, 0.01, -0.01));
    add("TriangleAboveItsEdge", triangle(), seen(0.15, 0.01, 0.4));
    add("TriangleAboveItsCorner", triangle(), seen(1.0, 0.01, 0.0));
    add("TriangleGrazing", triangle(), seen(-2.0, 0.05, 0.3));
    add("SphereNear", Sphere{frame, 0.7}, seen(0.2, 0.75, 0.1));
    add("SphereFar", Sphere{frame, 0.7}, seen(-20.0, 50.0, 30.0));
    add("SphereVeryFar", Sphere{frame, 0.001}, seen(-20.0, 50.0, 30.0));
    add("SphereInside", Sphere{frame, 0.7}, seen(0.2, 0.3, -0.1));
    add("SphereCentre", Sphere{frame, 0.7}, seen(0.0, 0.0, 0.0));
    add("DiskNear", Disk{frame, 0.7}, seen(0.3, 0.3, 0.1));
    add("DiskFar", Disk{frame, 0.7}, seen(-20.0, 50.0, 30.0));
    add("DiskOnAxis", Disk{frame, 0.7}, seen(0.0, 0.6, 0.0));
    add("CylinderNear", Cylinder{frame, 0.5, 1.2}, seen(0.5, 0.9, 0.6));
    add("CylinderFar", Cylinder{frame, 0.5, 1.2}, seen(-20.0, 10.0, 30.0));
    add("CylinderOnAxis", Cylinder{frame, 0.5, 1.2}, seen(0.0, 1.5, 0.0));
    add("CylinderBeside", Cylinder{frame, 0.5, 1.2}, seen(1.2, 0.1, 0.0));
    add("CylinderInside", Cylinder{frame, 0.5, 1.2}, seen(0.1, 0.2, 0.1));
    add("ConeNear", Cone{frame, -1.0, 0.6}, seen(0.8, -0.4, 0.2));
    add("ConeFar", Cone{frame, -1.0, 0.6}, seen(-20.0, 10.0, 30.0));
    add("ConeAboveApex", Cone{frame, -1.0, 0.6}, seen(0.0, 0.5, 0.0));
    add("ConeBelowBase", Cone{frame, -1.0, 0.6}, seen(0.1, -1.8, 0.0));
    add("ConeInside", Cone{frame, -1.0, 0.6}, seen(0.05, -0.6, 0.1));
    add("ConeUpright", Cone{frame, 1.0, 2.0}, seen(0.5, -0.6, 0.1));
    return cases;
}

using Moments = std::array<std::vector<double>, 4>;

/// A cone of directions that surely holds a light, as seen from the shading point.
struct DirectionCone {
    glm::dmat3 frame; ///< axis y
    double cosine;    ///< of the half angle; -1 is all directions

    double solidAngle() const { return 2.0 * std::numbers::pi * (1.0 - cosine); }

    glm::dvec3 uniformDirection(RandomNumbers& random) const {
        const double y = 1.0 - random.unit() * (1.0 - cosine);
        const double phi = 2.0 * std::numbers::pi * random.unit();
        const double radius = std::sqrt(std::max(0.0, 1.0 - y * y));
        return frame * glm::dvec3(radius * std::cos(phi), y, radius * std::sin(phi));
    }

    /// Adds what is integrated over the light's directions: the solid angle, and moments that
    /// differ between a density of the wrong shape and the right one, each 1 at most.
    void addTo(Moments& sums, const glm::dvec3& w, double weight) const {
        const glm::dvec3 local = glm::transpose(frame) * w;
        const double sine = cosine > 0.0 ? std::sqrt(1.0 - cosine * cosine) : 1.0;
        const std::array values = {1.0, (1.0 - local.y) / (1.0 - cosine), local.x / sine,
                                   local.z / sine};
        for (size_t k = 0; k < values.size(); ++k)
            sums[k].push_back(weight * values[k]);
    }
};

class LightSamplingTest : public GpuTest, public testing::WithParamInterface<LightCase> {
protected:
    LightSamplingTest() {
        Scene scene = sceneOf({GetParam().shape});
        Material emitting;
        emitting.emission = glm::dvec3(kRadiance);
        emitting.emitsFromFrontOnly = true;
        scene.materials.push_back(emitting);
        if (auto* mesh = std::get_if<Mesh>(&scene.shapes[0].geometry))
            mesh->triangles[0].material = 1;
        packed_ = packAsProgram(scene).packed;
        shadingPoint_ = glm::vec3(GetParam().shadingPoint - packed_.origin);
        sample();
    }

    /// Whether a direction from the shading point meets the light.
    bool meetsLight(const glm::dvec3& direction) const {
        const Line line{Vec3(shadingPoint_), Vec3(direction)};
        if (packed_.lights[0].primitive & shared::kQuadricBit)
            return firstHit(packed_.quadrics[0], line) < kInfinity;
        const TriangleCrossing crossing = crossTriangle(packed_.triangles[0], line);
        return crossing.insideBy >= 0.0L && crossing.t > 0.0L;
    }

    /// Distance of a sample from the light's surface.
    double distanceFromLight(const shared::TestLightSample& point) const {
        const Vec3 position(point.position);
        if (packed_.lights[0].primitive & shared::kQuadricBit)
            return double(
                std::abs(faceAt(packed_.quadrics[0], position, Vec3(point.normal)).distance));
        const shared::Triangle& t = packed_.triangles[0];
        const Vec3 normal =
            glm::normalize(glm::cross(Vec3(t.v1) - Vec3(t.v0), Vec3(t.v2) - Vec3(t.v0)));
        return double(std::abs(glm::dot(position - Vec3(t.v0), normal)));
    }

    glm::dvec3 directionTo(const shared::TestLightSample& point) const {
        return glm::normalize(glm::dvec3(point.position) - glm::dvec3(shadingPoint_));
    }

    DirectionCone coneOfSamples() const {
        glm::dvec3 sum(0.0);
        for (const shared::TestLightSample& point : samples_)
            sum += directionTo(point);
        const glm::dvec3 axis = glm::normalize(sum);
        double widest = 0.0; // 1 - cosine
        for (const shared::TestLightSample& point : samples_)
            widest = std::max(widest, 1.0 - glm::dot(directionTo(point), axis));
        const bool isAllAround = glm::length(sum) < 0.5 * kSamples;
        return {rotationTakingYTo(axis), isAllAround ? -1.0 : std::max(-1.0, 1.0 - 1.1 * widest)};
    }

    GpuScene packed_;
    glm::vec3 shadingPoint_;
    std::vector<shared::TestLightSample> samples_;

private:
    void sample() {
        RandomNumbers random(33);
        std::vector<shared::TestLightQuery> queries;
        for (uint32_t i = 0; i < kSamples; ++i)
            queries.push_back({shadingPoint_,
                               0,
                               {random.deviceUnit(), random.deviceUnit(), 0.0f, 0.0f},
                               1,
                               0,
                               0,
                               0});
        for (const float x : {0.0f, 1.0f - 0x1p-24f})
            for (const float y : {0.0f, 1.0f - 0x1p-24f})
                queries.push_back({shadingPoint_, 0, {x, y, 0.0f, 0.0f}, 1, 0, 0, 0});
        const SceneBuffers buffers(testDevice(), packed_);
        samples_ = runKernel<shared::TestLightSample>(kLightSampleSpirv, queries,
                                                      buffers.bindings(), kTestInputBinding);
    }
};

TEST_P(LightSamplingTest, LiesOnTheLightWithOneDensity) {
    double worstPdf = 0.0;
    for (const shared::TestLightSample& point : samples_) {
        ASSERT_TRUE(std::isfinite(point.pdf) && point.pdf >= 0.0f);
        EXPECT_LE(distanceFromLight(point), point.error);
        const glm::dvec3 toShadingPoint = glm::dvec3(shadingPoint_) - glm::dvec3(point.position);
        const double facing = glm::dot(toShadingPoint, glm::dvec3(point.normal));
        if (std::abs(facing) > 1e-6 * glm::length(toShadingPoint))
            EXPECT_EQ(glm::vec3(point.emitted), facing > 0.0 ? kRadiance : glm::vec3(0.0f));
        if (point.pdf > 0.0f)
            worstPdf = std::max(worstPdf, std::abs(double(point.pdfOfHit) / point.pdf - 1.0));
    }
    RecordProperty("pdfDifference", std::to_string(worstPdf));
    EXPECT_LT(worstPdf, 1e-4);
}

TEST_P(LightSamplingTest, IntegratesToTheSolidAngle) {
    const DirectionCone cone = coneOfSamples();
    Moments sampled;
    for (const shared::TestLightSample& point : samples_)
        cone.addTo(sampled, directionTo(point), point.pdf > 0.0f ? 1.0 / point.pdf : 0.0);
    Moments traced;
    RandomNumbers random(34);
    for (uint32_t i = 0; i < kOracleRays; ++i) {
        const glm::dvec3 w = cone.uniformDirection(random);
        cone.addTo(traced, w, meetsLight(w) ? cone.solidAngle() : 0.0);
    }
    for (size_t k = 0; k < sampled.size(); ++k) {
        const Estimate bySamples = estimate(sampled[k]);
        const Estimate byRays = estimate(traced[k]);
        const double error = std::hypot(bySamples.standardError, byRays.standardError);
        EXPECT_NEAR(bySamples.mean, byRays.mean, 4.0 * error + 1e-5 * cone.solidAngle())
            << "moment " << k;
    }
}

INSTANTIATE_TEST_SUITE_P(Of, LightSamplingTest, testing::ValuesIn(lightCases()),
                         [](const auto& instance) { return instance.param.name; });

} // namespace
} // namespace calotype::test
