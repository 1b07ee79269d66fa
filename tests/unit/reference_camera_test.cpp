// The reference tracer's film and lens.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "reference/camera.h"
#include "support/oracle_filter.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

using reference::cameraRay;
using reference::Ray;

constexpr glm::uvec2 kFilm(300, 200);

/// Askew, off the origin.
Camera someCamera() {
    Camera camera;
    camera.position = {3.0, -1.0, 2.0};
    camera.forward = glm::normalize(glm::dvec3(1.0, 2.0, -3.0));
    camera.right = glm::normalize(glm::cross(camera.forward, {0.0, 1.0, 0.0}));
    camera.up = glm::cross(camera.right, camera.forward);
    return camera;
}

class ReferenceFilterTest : public testing::TestWithParam<FilmFilter> {};

TEST_P(ReferenceFilterTest, IsInverted) {
    const OracleFilter oracle(GetParam());
    for (int i = 0; i < 1000; ++i) {
        const double u = (i + 0.5) / 1000.0;
        const glm::dvec2 position = reference::samplePixel(GetParam(), {u, 1.0 - u});
        EXPECT_NEAR(oracle.shareBelow(position.x - 0.5), u, 1e-6);
        EXPECT_NEAR(oracle.shareBelow(position.y - 0.5), 1.0 - u, 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(Each, ReferenceFilterTest,
                         testing::Values(FilmFilter::Box, FilmFilter::Tent, FilmFilter::Gaussian,
                                         FilmFilter::BlackmanHarris));

TEST(ReferenceCameraTest, SeesItsFieldOfView) {
    Camera camera = someCamera();
    camera.verticalFov = 0.8;
    const double halfHeight = std::tan(0.4);
    // The film's position in its own units, and where it should lie at a distance of one.
    const auto expectRay = [&](const glm::dvec2& film, double right, double up) {
        const Ray ray = cameraRay(camera, kFilm, film, {0.5, 0.5});
        EXPECT_EQ(ray.origin, camera.position);
        const glm::dvec3 expected =
            glm::normalize(camera.forward + right * camera.right + up * camera.up);
        EXPECT_NEAR(glm::distance(ray.direction, expected), 0.0, 1e-14);
    };
    expectRay({150, 100}, 0.0, 0.0);
    expectRay({150, 0}, 0.0, halfHeight);
    expectRay({150, 200}, 0.0, -halfHeight);
    expectRay({300, 100}, 1.5 * halfHeight, 0.0);
    expectRay({0, 0}, -1.5 * halfHeight, halfHeight);
}

TEST(ReferenceCameraTest, SendsParallelRaysFromItsHeight) {
    Camera camera = someCamera();
    camera.projection = Projection::Orthographic;
    camera.viewHeight = 4.0;
    const Ray ray = cameraRay(camera, kFilm, {300, 0}, {0.5, 0.5});
    EXPECT_NEAR(glm::distance(ray.direction, camera.forward), 0.0, 1e-15);
    EXPECT_NEAR(glm::distance(ray.origin, camera.position + 3.0 * camera.right + 2.0 * camera.up),
                0.0, 1e-14);
}

// All rays of one point of the film meet in the plane in focus, where the pinhole's ray is.
TEST(ReferenceCameraTest, FocusesThroughAllOfItsLens) {
    RandomNumbers random(221);
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        Camera camera = someCamera();
        camera.projection = projection;
        camera.focusDistance = 7.0;
        const auto inFocus = [&](const Ray& ray) {
            const double t = (7.0 - glm::dot(ray.origin - camera.position, camera.forward)) /
                             glm::dot(ray.direction, camera.forward);
            return ray.origin + t * ray.direction;
        };
        const glm::dvec2 film(40.0, 130.0);
        const Ray pinhole = cameraRay(camera, kFilm, film, {0.5, 0.5});
        camera.lensRadius = 0.3;
        double meanSquare = 0.0;
        glm::dvec3 mean(0.0);
        constexpr int kSamples = 20'000;
        for (int i = 0; i < kSamples; ++i) {
            const Ray ray = cameraRay(camera, kFilm, film, {random.unit(), random.unit()});
            ASSERT_NEAR(glm::distance(inFocus(ray), inFocus(pinhole)), 0.0, 1e-12);
            const glm::dvec3 onLens = ray.origin - pinhole.origin;
            ASSERT_NEAR(glm::dot(onLens, camera.forward), 0.0, 1e-14);
            ASSERT_LE(glm::length(onLens), 0.3 + 1e-14);
            mean += onLens / double(kSamples);
            meanSquare += glm::dot(onLens, onLens) / kSamples;
        }
        // Uniform on the disk: r^2 has the mean R^2 / 2 and deviates by R^2 / sqrt(12).
        EXPECT_NEAR(meanSquare, 0.045, 4.0 * 0.09 / std::sqrt(12.0 * kSamples));
        EXPECT_NEAR(glm::length(mean), 0.0, 4.0 * 0.3 / std::sqrt(2.0 * kSamples));
    }
}

} // namespace
} // namespace calotype::test
