// Every sampler at the ends of its random numbers' range, 0 and 1 - 2^-24, and beside them.
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "kernels/camera_ray.spv.h"
#include "kernels/film_sample.spv.h"
#include "kernels/light_sample.spv.h"
#include "kernels/scattering.spv.h"
#include "pack/filter_table.h"
#include "pack/pack_camera.h"
#include "render/scene_buffers.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/oracle_filter.h"
#include "support/oracle_quadric.h"
#include "support/primitive_scene.h"
#include "support/test_materials.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

/// A random number is a multiple of 2^-24.
constexpr uint32_t kNumbers = 1u << 24;
constexpr float kLargest = 1.0f - 0x1p-24f;
constexpr std::array kEnds = {0.0f, 0x1p-24f, 0.25f, 0.5f, 1.0f - 0x1p-23f, kLargest};

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x + v.y + v.z); }

class PinnedNumbersTest : public GpuTest {
protected:
    /// The only light of a scene.
    static std::vector<shared::TestLightSample>
    sampleLight(const GpuScene& packed, const std::vector<shared::TestLightQuery>& queries) {
        const SceneBuffers buffers(testDevice(), packed);
        return runKernel<shared::TestLightSample>(kLightSampleSpirv, queries, buffers.bindings(),
                                                  kTestInputBinding);
    }

    static GpuScene packedLight(Shape shape) {
        Scene scene = sceneOf({std::move(shape)});
        scene.materials[0].emission = glm::dvec3(1.0);
        scene.materials[0].emitsFromFrontOnly = true;
        return packAsProgram(scene).packed;
    }
};

std::vector<Shape> everyLight() {
    return {shapeOf(singleTriangle({0, 0, 0}, {1, 0, 0}, {0.3, 0, 0.8})),
            shapeOf(singleTriangle({0, 0, 0}, {1, 0, 0}, {0.5, 0, 1e-7})),
            shapeOf(singleTriangle({0, 0, 0}, {0.5, 0, 0}, {1, 1e-6, 0})),
            shapeOf(singleTriangle({1e-9, 0, 0}, {0, 1e-9, 0}, {0, 0, 1e-9})),
            shapeOf(singleTriangle({-1e9, 0.3, -1e9}, {1e9, 0.3, -1e9}, {0, 0.3, 1e9})),
            shapeOf(Sphere{{}, 0.7}),
            shapeOf(Disk{{}, 0.7}),
            shapeOf(Cylinder{{}, 0.5, 1.2}),
            shapeOf(Cylinder{{}, 1e-4, 10.0}),
            shapeOf(Cylinder{{}, 10.0, 1e-4}),
            shapeOf(Cone{{}, -1.0, 0.6}),
            shapeOf(Cone{{}, 1e-4, 1e5}),
            shapeOf(Cone{{}, -10.0, 1e-5})};
}

TEST_F(PinnedNumbersTest, FindPointsOfLights) {
    for (const Shape& shape : everyLight()) {
        const GpuScene packed = packedLight(shape);
        const bool isQuadric = (packed.lights[0].primitive & shared::kQuadricBit) != 0;
        std::vector<shared::TestLightQuery> queries; // at every pair of ends
        for (const glm::dvec3& from :
             {glm::dvec3(0.0), glm::dvec3(0.1, 0.3, -0.1), glm::dvec3(0.0, 2.0, 0.0),
              glm::dvec3(0.5, 0.0, 0.0), glm::dvec3(-20.0, -50.0, 30.0), glm::dvec3(1e6, 0.0, 0.0),
              // For the first triangle: its corners, its plane, and close to all of them.
              glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.3, 0.0, 0.8), glm::dvec3(0.4, 0.0, 0.2),
              glm::dvec3(0.4, 1e-6, 0.2), glm::dvec3(0.4, -1e-6, 0.0), glm::dvec3(1.0, 1e-6, 0.0),
              glm::dvec3(0.4, 1e-20, 0.2), glm::dvec3(1e-20, 1e-20, 0.0),
              glm::dvec3(-1.0, 0.0, -1.0), glm::dvec3(-1.0, 1e-6, -1.0),
              glm::dvec3(1e5, 1e6, -1e5)})
            for (const float x : kEnds)
                for (const float y : kEnds)
                    queries.push_back(
                        {glm::vec3(from - packed.origin), 0, {x, y, x, y}, 1, 0, 0, 0});
        const auto points = sampleLight(packed, queries);
        for (size_t i = 0; i < points.size(); ++i) {
            const shared::TestLightSample& point = points[i];
            ASSERT_TRUE(isFinite(point.position) && isFinite(point.normal));
            ASSERT_TRUE(std::isfinite(point.pdf) && point.pdf >= 0.0f);
            ASSERT_NEAR(glm::length(point.normal), 1.0f, 1e-6f);
            ASSERT_EQ(point.chosen, 0u);
            if (isQuadric) {
                const FaceAt face =
                    faceAt(packed.quadrics[0], Vec3(point.position), Vec3(point.normal));
                ASSERT_LE(std::abs(face.distance), point.error);
            }
            const glm::dvec3 away =
                glm::dvec3(queries[i].shadingPoint) - glm::dvec3(point.position);
            const double facing = glm::dot(away, glm::dvec3(point.normal)) / glm::length(away);
            if (std::abs(facing) > 1e-5 && point.pdf > 0.0f) {
                ASSERT_EQ(point.emitted.x, facing > 0.0 ? 1.0f : 0.0f);
                ASSERT_NEAR(point.pdfOfHit / point.pdf, 1.0f, 1e-4f);
            }
        }
    }
}

TEST_F(PinnedNumbersTest, ChooseLightsThatShine) {
    std::vector<Shape> shapes;
    for (uint32_t i = 0; i < 100; ++i)
        shapes.push_back(shapeOf(Sphere{{glm::dmat3(1.0), {double(i), 0.0, 0.0}}, 0.1}, i % 4));
    Scene scene = sceneOf(std::move(shapes));
    scene.materials.resize(4);
    for (uint32_t i = 0; i < 3; ++i)
        scene.materials[i].emission = glm::dvec3(i == 0 ? 1e-6 : i == 1 ? 1.0 : 1e6);
    const GpuScene packed = packAsProgram(scene).packed;
    const uint32_t count = packed.lightCount;
    ASSERT_EQ(count, 75u);
    std::vector<shared::TestLightQuery> queries;
    std::vector<uint32_t> chosen;
    const auto firstOf = [&](uint32_t column) { return (column * kNumbers + count - 1) / count; };
    for (uint32_t column = 0; column < count; ++column) {
        const shared::Light& light = packed.lights[column];
        const uint32_t first = firstOf(column);
        const uint32_t last = firstOf(column + 1) - 1;
        for (const uint32_t number : {first, last})
            for (const float between : kEnds) {
                const float u = static_cast<float>(number) / static_cast<float>(kNumbers);
                queries.push_back({{}, 0, {0.5f, 0.5f, u, between}, count, 0, 0, 0});
                chosen.push_back(number - first < light.ownNumbers ? column : light.alias);
            }
    }
    const SceneBuffers buffers(testDevice(), packed);
    const auto results = runKernel<shared::TestLightSample>(kLightSampleSpirv, queries,
                                                            buffers.bindings(), kTestInputBinding);
    for (size_t i = 0; i < results.size(); ++i) {
        ASSERT_EQ(results[i].chosen, chosen[i]);
        ASSERT_GT(packed.lights[chosen[i]].selectionProbability, 0.0f);
    }
}

TEST_F(PinnedNumbersTest, ScatterToTheRightSide) {
    std::vector<TestMaterial> materials = testMaterials();
    for (const double ior : {1.0, 1.5, 1.0 / 1.5}) {
        TestMaterial glass;
        glass.name = "glass of index " + std::to_string(ior);
        glass.material.type = MaterialType::Dielectric;
        glass.material.color = glm::dvec3(1.0);
        glass.material.ior = ior;
        materials.push_back(glass);
    }
    for (const TestMaterial& test : materials) {
        std::vector<shared::TestScattering> events;
        for (const double cosine : {1.0, 0.7, 0.04, 1e-3, 1e-6})
            for (const float u1 : kEnds)
                for (const float u2 : kEnds)
                    for (const float u3 : kEnds) {
                        events.push_back(scatteringOn(test.material, directionAt(cosine, 0.8)));
                        events.back().u1 = u1;
                        events.back().u2 = u2;
                        events.back().u3 = u3;
                    }
        for (const auto& scattered : runKernel<shared::TestScattered>(kScatteringSpirv, events)) {
            ASSERT_TRUE(isFinite(scattered.wi) && isFinite(scattered.weight)) << test.name;
            ASSERT_TRUE(std::isfinite(scattered.pdf) && scattered.pdf >= 0.0f) << test.name;
            ASSERT_NEAR(glm::length(scattered.wi), 1.0f, 1e-5f) << test.name;
            if (scattered.weight != glm::vec3(0.0f)) {
                ASSERT_GE(scattered.crosses != 0 ? -scattered.wi.z : scattered.wi.z, 0.0f)
                    << test.name;
                ASSERT_LE(scattered.weight.x, 8.0f) << test.name;
            }
            if (test.material.type != MaterialType::Dielectric)
                ASSERT_EQ(scattered.pdf, scattered.pdfAgain) << test.name;
        }
    }
}

TEST_F(PinnedNumbersTest, StayOnTheLens) {
    std::vector<shared::TestFilmQuery> queries;
    for (const double radius : {1e-6, 0.1, 1e3}) {
        Camera camera;
        camera.lensRadius = radius;
        camera.focusDistance = 4.0;
        const shared::Camera packed = packCamera(camera, FilmFilter::Box, glm::dvec3(0.0), 1.0);
        for (const float x : kEnds)
            for (const float y : kEnds)
                queries.push_back({packed, {64.0f * x, 64.0f * y}, {x, y}, {64, 64}, 0, 0});
    }
    const auto rays = runKernel<shared::TestCameraRay>(kCameraRaySpirv, queries);
    for (size_t i = 0; i < rays.size(); ++i) {
        const double radius = glm::length(queries[i].camera.lensRight);
        ASSERT_TRUE(isFinite(rays[i].origin));
        ASSERT_LE(glm::length(glm::dvec3(rays[i].origin)), radius * (1.0 + 4.0 * kRoundoffOfFloat));
        ASSERT_NEAR(glm::length(glm::dvec3(rays[i].direction)), 1.0, 4.0 * kRoundoffOfFloat);
        ASSERT_LT(rays[i].direction.z, 0.0f);
    }
}

TEST_F(PinnedNumbersTest, StayWithinTheFiltersSupport) {
    for (const FilmFilter filter :
         {FilmFilter::Box, FilmFilter::Tent, FilmFilter::Gaussian, FilmFilter::BlackmanHarris}) {
        GpuScene table;
        table.filterSteps = filterSteps(filter);
        const PrimitiveScene scene(std::move(table));
        const SceneBuffers buffers(testDevice(), scene.packed());
        const shared::Camera camera = packCamera(Camera{}, filter, glm::dvec3(0.0), 1.0);
        std::vector<glm::vec4> queries;
        for (const float x : kEnds)
            for (const float y : kEnds)
                queries.emplace_back(x, y, static_cast<float>(camera.filterIsBox), 0.0f);
        const double radius = OracleFilter(filter).radius();
        for (const glm::vec2& position : runKernel<glm::vec2>(
                 kFilmSampleSpirv, queries, buffers.bindings(), kTestInputBinding)) {
            ASSERT_LE(std::abs(position.x - 0.5), radius);
            ASSERT_LE(std::abs(position.y - 0.5), radius);
        }
    }
}

} // namespace
} // namespace calotype::test
