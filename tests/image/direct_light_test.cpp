// Direct light on a diffuse floor against closed forms of the irradiance at a point.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "support/agreement.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"
#include "support/statistics.h"

namespace calotype::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAlbedo = 0.6;
constexpr double kRadiance = 3.0;

class DirectLightTest : public GpuTest {};

/// Irradiance at the origin, on a plane with normal +y, from a polygon that emits `kRadiance`
/// (Lambert 1760): E = L / 2 * sum of angle_i * (edge normal_i . n), for a polygon above the plane
/// whose front faces the origin.
double polygonIrradiance(const std::vector<glm::dvec3>& corners) {
    double sum = 0.0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::normalize(corners[i]);
        const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()]);
        sum += std::acos(glm::dot(a, b)) * glm::normalize(glm::cross(a, b)).y;
    }
    return 0.5 * kRadiance * std::abs(sum);
}

/// Renders a tiny patch of floor about the origin, in which the irradiance hardly changes, and
/// expects its mean radiance to be albedo * E / pi: within three standard errors over blocks of
/// samples, which are independent, and within half a percent.
void expectFloorRadiance(SceneBuilder& builder, double irradiance) {
    constexpr uint32_t kSide = 32;
    constexpr size_t kBlocks = 64;
    const uint32_t floor = builder.material(kAlbedo, 0.0);
    builder.polygon({{-50, 0, 50}, {50, 0, 50}, {50, 0, -50}, {-50, 0, -50}}, floor);
    builder.lookDown(0.05, 1e-4);
    Scene& scene = builder.scene();
    scene.render.maxBounces = 1;
    DeviceTracer device(scene, squareSettings(scene, kSide, 0));
    const TileMeans rendered = renderTileMeans(device.tracer(), kSide, kSide, kBlocks);
    std::vector<double> means;
    for (size_t block = 0; block < kBlocks; ++block)
        means.push_back(rendered.whole(block).x);
    const double expected = kAlbedo * irradiance / kPi;
    const Estimate seen = estimate(means);
    EXPECT_NEAR(seen.mean, expected, 3.0 * seen.standardError);
    EXPECT_NEAR(seen.mean, expected, 0.005 * expected);
    EXPECT_GT(seen.standardError, 0.0);
}

TEST_F(DirectLightTest, Quad) {
    const std::vector<glm::dvec3> corners = {
        {-1.0, 1.5, -0.5}, {0.7, 1.5, -0.5}, {0.7, 1.5, 0.8}, {-1.0, 1.5, 0.8}};
    SceneBuilder builder;
    builder.polygon(corners, builder.material(0.0, kRadiance, true));
    expectFloorRadiance(builder, polygonIrradiance(corners));
}

TEST_F(DirectLightTest, TiltedTriangle) {
    const std::vector<glm::dvec3> corners = {{-0.4, 0.6, -0.5}, {1.2, 1.4, -0.3}, {0.2, 1.0, 0.9}};
    SceneBuilder builder;
    builder.polygon(corners, builder.material(0.0, kRadiance, true));
    expectFloorRadiance(builder, polygonIrradiance(corners));
}

// A disk of radius r at height h above the point: E = pi L r^2 / (r^2 + h^2).
TEST_F(DirectLightTest, DiskAbove) {
    SceneBuilder builder;
    const glm::dmat3 facingDown(1, 0, 0, 0, -1, 0, 0, 0, -1);
    const uint32_t lamp = builder.material(0.0, kRadiance, true);
    builder.add(makeShape(Disk{{facingDown, {0.0, 1.2, 0.0}}, 0.8}, lamp));
    expectFloorRadiance(builder, kPi * kRadiance * 0.64 / (0.64 + 1.44));
}

// A sphere wholly above the horizon, off the normal: E = pi L (r / d)^2 cos theta.
TEST_F(DirectLightTest, Sphere) {
    SceneBuilder builder;
    const glm::dvec3 center(0.6, 1.0, -0.2);
    const double radius = 0.4;
    builder.add(makeShape(Sphere{{glm::dmat3(1.0), center}, radius},
                          builder.material(0.0, kRadiance, true)));
    const double distance2 = glm::dot(center, center);
    expectFloorRadiance(builder, kPi * kRadiance * radius * radius / distance2 * center.y /
                                     std::sqrt(distance2));
}

// Seen from straight below, a closed cylinder is its lower cap.
TEST_F(DirectLightTest, CylinderAbove) {
    SceneBuilder builder;
    const uint32_t lamp = builder.material(0.0, kRadiance, true);
    builder.add(makeShape(Cylinder{{glm::dmat3(1.0), {0.0, 1.5, 0.0}}, 0.5, 1.0}, lamp));
    expectFloorRadiance(builder, kPi * kRadiance * 0.25 / (0.25 + 1.0));
}

// Seen from below its base, a cone with its apex up is that base.
TEST_F(DirectLightTest, ConeAbove) {
    SceneBuilder builder;
    const uint32_t lamp = builder.material(0.0, kRadiance, true);
    builder.add(makeShape(Cone{{glm::dmat3(1.0), {0.0, 1.7, 0.0}}, -0.7, 1.0}, lamp));
    expectFloorRadiance(builder, kPi * kRadiance * 0.49 / (0.49 + 1.0));
}

// Two lights of very different power: each is chosen by its power, and divided by that chance.
TEST_F(DirectLightTest, TwoUnequalLights) {
    const std::vector<glm::dvec3> large = {
        {-2.0, 2.0, -2.0}, {-0.5, 2.0, -2.0}, {-0.5, 2.0, 2.0}, {-2.0, 2.0, 2.0}};
    const std::vector<glm::dvec3> small = {{0.3, 0.5, 0.3}, {0.5, 0.5, 0.3}, {0.4, 0.5, 0.5}};
    SceneBuilder builder;
    const uint32_t lamp = builder.material(0.0, kRadiance, true);
    builder.polygon(large, lamp).polygon(small, lamp);
    expectFloorRadiance(builder, polygonIrradiance(large) + polygonIrradiance(small));
}

// The back of a one-sided light is black, and lights nothing.
TEST_F(DirectLightTest, OneSidedLightIsDarkBehind) {
    SceneBuilder builder;
    const uint32_t lamp = builder.material(0.0, kRadiance, true);
    builder.polygon({{-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1}}, lamp); // faces up
    builder.polygon({{-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}}, builder.material(0.5, 0.0));
    builder.lookDown(0.05, 1.0);
    builder.scene().render = {16, 3, 0};
    for (const glm::vec3& pixel : renderScene(builder.scene()).image.pixels)
        EXPECT_EQ(pixel, glm::vec3(0.0f));
}

// A light hidden from the camera is not seen, but lights.
TEST_F(DirectLightTest, HiddenLightLightsButIsNotSeen) {
    const std::vector<glm::dvec3> corners = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
    SceneBuilder builder;
    builder.polygon(corners, builder.material(0.0, kRadiance, true));
    builder.scene().materials[0].visibleToCamera = false;
    builder.polygon({{-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}},
                    builder.material(kAlbedo, 0.0));
    builder.lookDown(3.0, 1e-3);
    builder.scene().render = {1024, 1, 0};
    double sum = 0.0;
    const Image image = renderScene(builder.scene()).image;
    for (const glm::vec3& pixel : image.pixels)
        sum += pixel.x;
    const double expected = kAlbedo * polygonIrradiance(corners) / kPi;
    EXPECT_NEAR(sum / static_cast<double>(image.pixels.size()), expected, 0.005 * expected);
}

} // namespace
} // namespace calotype::test
