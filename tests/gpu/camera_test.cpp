// Camera rays against a pinhole, a parallel projection and a thin lens in double.
#include <cmath>
#include <cstring>
#include <numbers>

#include <glm/geometric.hpp>

#include "kernels/camera_ray.spv.h"
#include "pack/pack_camera.h"
#include "shared/specialization.h"
#include "support/chi_square.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/kernels/test_structs.h"
#include "support/random_numbers.h"
#include "support/test_quadrics.h"

namespace calotype::test {
namespace {

const glm::uvec2 kImageSize(640, 480);
constexpr double kAspectRatio = 640.0 / 480.0;
const glm::dvec3 kOrigin(100.0, -20.0, 3.0); ///< of the packed scene, in the world

Camera cameraAt(Projection projection, RandomNumbers& random) {
    const glm::dmat3 frame = randomRotation(random);
    Camera camera;
    camera.projection = projection;
    camera.position = kOrigin + random.inBall();
    camera.right = frame[0];
    camera.up = frame[1];
    camera.forward = -frame[2];
    camera.verticalFov = random.between(0.1, 2.8);
    camera.viewHeight = random.powerOfTen(-1.0, 1.0);
    camera.focusDistance = random.powerOfTen(-0.5, 1.0);
    return camera;
}

std::vector<Camera> variedCameras(Projection projection, double lensRadius) {
    RandomNumbers random(161);
    std::vector<Camera> cameras;
    for (int i = 0; i < 30; ++i) {
        cameras.push_back(cameraAt(projection, random));
        cameras.back().lensRadius = lensRadius * random.between(0.2, 1.0);
    }
    return cameras;
}

/// The film's corners, its centre and random positions, from random points of the lens.
std::vector<shared::TestFilmQuery> queriesOf(const Camera& camera, RandomNumbers& random) {
    const shared::Camera packed = packCamera(camera, FilmFilter::Box, kOrigin, kAspectRatio);
    const glm::vec2 size(kImageSize);
    std::vector<glm::vec2> positions = {{0, 0}, {size.x, 0}, {0, size.y}, size, 0.5f * size};
    for (int i = 0; i < 100; ++i)
        positions.push_back({random.between(0, kImageSize.x), random.between(0, kImageSize.y)});
    std::vector<shared::TestFilmQuery> queries;
    for (const glm::vec2& position : positions)
        queries.push_back(
            {packed, position, {random.deviceUnit(), random.deviceUnit()}, kImageSize, 0, 0});
    return queries;
}

/// Position in the view's plane: -1 at the left and the bottom, 1 at the right and the top.
glm::dvec2 inView(const glm::vec2& film) {
    return {2.0 * film.x / kImageSize.x - 1.0, 1.0 - 2.0 * film.y / kImageSize.y};
}

/// The unit direction in which a pinhole sees a position of the film.
glm::dvec3 pinholeDirection(const Camera& camera, const glm::vec2& film) {
    const glm::dvec2 tangent = inView(film) * std::tan(0.5 * camera.verticalFov);
    return glm::normalize(camera.forward + tangent.x * kAspectRatio * camera.right +
                          tangent.y * camera.up);
}

/// The point of the view's plane from which a parallel projection sees, relative to kOrigin.
glm::dvec3 parallelOrigin(const Camera& camera, const glm::vec2& film) {
    const glm::dvec2 metres = inView(film) * (0.5 * camera.viewHeight);
    return camera.position - kOrigin + metres.x * kAspectRatio * camera.right +
           metres.y * camera.up;
}

/// Where all rays of a position of the film meet, relative to kOrigin.
glm::dvec3 pointInFocus(const Camera& camera, const glm::vec2& film) {
    if (camera.projection == Projection::Orthographic)
        return parallelOrigin(camera, film) + camera.focusDistance * camera.forward;
    const glm::dvec3 direction = pinholeDirection(camera, film);
    return camera.position - kOrigin +
           direction * (camera.focusDistance / glm::dot(direction, camera.forward));
}

double distanceFromRay(const shared::TestCameraRay& ray, const glm::dvec3& point) {
    return glm::length(glm::cross(point - glm::dvec3(ray.origin), glm::dvec3(ray.direction)));
}

class CameraRayTest : public GpuTest {
protected:
    std::vector<shared::TestCameraRay> run(const std::vector<shared::TestFilmQuery>& queries,
                                           const std::vector<vk::Bool32>& features = {}) {
        return runKernel<shared::TestCameraRay>(kCameraRaySpirv, queries, {}, 0, features);
    }

    /// Calls check(camera, query, ray) for many rays of many cameras.
    template <typename Check>
    void forEachRay(const std::vector<Camera>& cameras, const Check& check) {
        RandomNumbers random(162);
        for (const Camera& camera : cameras) {
            const auto queries = queriesOf(camera, random);
            const auto rays = run(queries);
            for (size_t i = 0; i < queries.size(); ++i) {
                ASSERT_NEAR(glm::length(glm::dvec3(rays[i].direction)), 1.0,
                            4.0 * kRoundoffOfFloat);
                ASSERT_GT(rays[i].tMax, 1e18f);
                check(camera, queries[i], rays[i]);
                if (HasFailure())
                    return;
            }
        }
    }
};

TEST_F(CameraRayTest, OfAPinholeIsThePerspectives) {
    forEachRay(variedCameras(Projection::Perspective, 0.0), [](const Camera& camera,
                                                               const auto& query, const auto& ray) {
        const glm::dvec3 wanted = pinholeDirection(camera, query.position);
        EXPECT_LT(glm::length(glm::dvec3(ray.direction) - wanted), 8.0 * kRoundoffOfFloat);
        EXPECT_LT(glm::length(glm::dvec3(ray.origin) + kOrigin - camera.position),
                  2.0 * kRoundoffOfFloat);
    });
}

TEST_F(CameraRayTest, OfAParallelProjectionIsParallel) {
    forEachRay(variedCameras(Projection::Orthographic, 0.0), [](const Camera& camera,
                                                                const auto& query,
                                                                const auto& ray) {
        EXPECT_LT(glm::length(glm::dvec3(ray.direction) - camera.forward), 4.0 * kRoundoffOfFloat);
        EXPECT_LT(glm::length(glm::dvec3(ray.origin) - parallelOrigin(camera, query.position)),
                  8.0 * kRoundoffOfFloat * (1.0 + camera.viewHeight));
    });
}

// Pixel (0, 0) is top left, for a camera that looks along -z.
TEST_F(CameraRayTest, StartsAtTheTopLeft) {
    const shared::Camera camera =
        packCamera(Camera{}, FilmFilter::Box, glm::dvec3(0.0), kAspectRatio);
    const auto rays = run({{camera, {0, 0}, {}, kImageSize, 0, 0}});
    EXPECT_LT(rays[0].direction.x, -0.1f);
    EXPECT_GT(rays[0].direction.y, 0.1f);
    EXPECT_LT(rays[0].direction.z, -0.1f);
}

TEST_F(CameraRayTest, OfALensMeetsTheOthersInThePlaneInFocus) {
    for (const auto projection : {Projection::Perspective, Projection::Orthographic})
        forEachRay(variedCameras(projection, 0.3),
                   [](const Camera& camera, const auto& query, const auto& ray) {
                       const glm::dvec3 focus = pointInFocus(camera, query.position);
                       const double reach = 2.0 + camera.lensRadius + glm::length(focus);
                       EXPECT_LT(distanceFromRay(ray, focus), 16.0 * kRoundoffOfFloat * reach);
                       EXPECT_GT(glm::dot(glm::dvec3(ray.direction), camera.forward), 0.0);
                   });
}

TEST_F(CameraRayTest, OfALensStartsAnywhereOnItsDiskAlike) {
    RandomNumbers random(163);
    constexpr uint32_t kRings = 12;
    constexpr uint32_t kSectors = 12;
    Camera camera = cameraAt(Projection::Perspective, random);
    camera.lensRadius = 0.25;
    const shared::Camera packed = packCamera(camera, FilmFilter::Box, kOrigin, kAspectRatio);
    std::vector<shared::TestFilmQuery> queries;
    for (int i = 0; i < 200'000; ++i)
        queries.push_back({packed,
                           {random.between(0, kImageSize.x), random.between(0, kImageSize.y)},
                           {random.deviceUnit(), random.deviceUnit()},
                           kImageSize,
                           0,
                           0});
    std::vector<uint64_t> counts(kRings * kSectors);
    for (const shared::TestCameraRay& ray : run(queries)) {
        const glm::dvec3 onLens = glm::dvec3(ray.origin) + kOrigin - camera.position;
        const double x = glm::dot(onLens, camera.right) / camera.lensRadius;
        const double y = glm::dot(onLens, camera.up) / camera.lensRadius;
        ASSERT_NEAR(glm::dot(onLens, camera.forward), 0.0, 4.0 * kRoundoffOfFloat);
        ASSERT_LE(x * x + y * y, 1.0 + 32.0 * kRoundoffOfFloat);
        const double turns = 0.5 + std::atan2(y, x) / (2.0 * std::numbers::pi);
        const auto ring = std::min(static_cast<uint32_t>((x * x + y * y) * kRings), kRings - 1);
        const auto sector = std::min(static_cast<uint32_t>(turns * kSectors), kSectors - 1);
        ++counts[ring * kSectors + sector];
    }
    const std::vector<double> chances(counts.size(), 1.0 / double(counts.size()));
    EXPECT_LT(chiSquare(counts, chances), chiSquareLimit(counts.size() - 1));
}

// A kernel specialised for no lens gives the very bits that one with a lens of no size gives.
TEST_F(CameraRayTest, OfALensOfNoSizeIsThePinholesBitForBit) {
    std::vector<vk::Bool32> withoutLens(shared::kFeatureCount, VK_TRUE);
    withoutLens[shared::kFeatureLens] = VK_FALSE;
    RandomNumbers random(164);
    for (const auto projection : {Projection::Perspective, Projection::Orthographic})
        for (const Camera& camera : variedCameras(projection, 0.0)) {
            const auto queries = queriesOf(camera, random);
            const auto rays = run(queries);
            const auto pinholes = run(queries, withoutLens);
            for (size_t i = 0; i < rays.size(); ++i) {
                EXPECT_EQ(rays[i].origin, pinholes[i].origin);
                EXPECT_EQ(rays[i].direction, pinholes[i].direction);
            }
        }
}

} // namespace
} // namespace calotype::test
