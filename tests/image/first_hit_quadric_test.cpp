// Quadrics as pixels show them, against the tests' own geometry in extended precision.
#include <cmath>

#include <glm/geometric.hpp>

#include "support/first_hits.h"
#include "support/oracle_coordinates.h"
#include "support/oracle_quadric.h"
#include "support/scene_builder.h"
#include "support/test_quadrics.h"

namespace calotype::test {
namespace {

/// Roundings of the hits (tests/gpu/quadric_hit_test.cpp), of the ray's direction (8, in
/// tests/gpu/camera_test.cpp) and of the position in the world.
constexpr double kAllowedRoundoffs = 16.0 + 8.0 + 8.0;
/// That angleInTurns states.
constexpr double kAngleError = 1e-7;

/// The ray through the middle of a pixel, relative to `origin`.
Line pixelLine(const Camera& camera, const FilmSettings& film, uint32_t x, uint32_t y,
               const glm::dvec3& origin) {
    const Real aspectRatio = Real(film.width) / film.height;
    const Real right = (2.0L * (x + 0.5L) / film.width - 1.0L) * aspectRatio;
    const Real up = 1.0L - 2.0L * (y + 0.5L) / film.height;
    const Vec3 across = right * Vec3(camera.right) + up * Vec3(camera.up);
    const Vec3 position(camera.position - origin);
    if (camera.projection == Projection::Orthographic)
        return {position + across * (0.5L * camera.viewHeight), Vec3(camera.forward)};
    const Real tangent = std::tan(0.5L * camera.verticalFov);
    return {position, glm::normalize(Vec3(camera.forward) + tangent * across)};
}

/// One quadric, turned somehow, up to 50 metres from the world's origin.
class FirstHitQuadricTest : public GpuTest,
                            public testing::WithParamInterface<std::tuple<uint32_t, Projection>> {
protected:
    Scene randomScene(RandomNumbers& random) const {
        SceneBuilder builder;
        const uint32_t grey = builder.material(0.5, 0.0);
        const glm::dvec3 middle = 50.0 * random.inBall();
        const RigidTransform pose{randomRotation(random), middle};
        switch (std::get<0>(GetParam())) {
        case shared::kSphere:
            builder.add(makeShape(Sphere{pose, 1.0}, grey));
            break;
        case shared::kCylinder:
            builder.add(makeShape(Cylinder{pose, 0.7, 1.5}, grey));
            break;
        case shared::kCone:
            builder.add(
                makeShape(Cone{pose, random.between(0.0, 1.0) < 0.5 ? 1.4 : -1.4, 0.6}, grey));
            break;
        default:
            builder.add(makeShape(Disk{pose, 1.2}, grey));
        }
        Scene& scene = builder.scene();
        scene.film = {29, 23};
        const glm::dmat3 frame = randomRotation(random);
        Camera& camera = scene.camera;
        camera.projection = std::get<1>(GetParam());
        camera.right = frame[0];
        camera.up = frame[1];
        camera.forward = -frame[2];
        camera.position = middle - 5.0 * camera.forward;
        camera.viewHeight = 3.5;
        return scene;
    }

    /// A pixel's hit on the only quadric of a packed scene. True where it shows the quadric.
    bool check(const FirstHit& hit, const Line& line, const Camera& camera,
               const GpuScene& packed) const {
        const shared::Quadric& quadric = packed.quadrics[0];
        const Real t = firstHit(quadric, line);
        const Vec3 position = Vec3(hit.position) - Vec3(packed.origin);
        const Real scale = roundingScale(quadric, line, t) +
                           glm::length(Vec3(packed.origin) + Vec3(quadric.center));
        const Real tolerance = kAllowedRoundoffs * kRoundoff * scale;
        const AllowedAnswers allowed = allowedAnswers(quadric, line, tolerance);
        if (hit.primitive == kNoPrimitive) {
            EXPECT_TRUE(allowed.miss);
            return false;
        }
        EXPECT_EQ(hit.primitive, 0u);
        EXPECT_TRUE(allowed.contains(glm::dot(position - line.origin, line.direction)));
        EXPECT_LT(glm::length(glm::cross(position - line.origin, line.direction)), tolerance);
        const Vec3 fromCamera = Vec3(hit.position) - Vec3(camera.position);
        EXPECT_LT(std::abs(hit.depth - glm::dot(fromCamera, Vec3(camera.forward))), tolerance);
        checkSurface(hit, position, line, quadric, tolerance);
        return true;
    }

private:
    static void checkSurface(const FirstHit& hit, const Vec3& position, const Line& line,
                             const shared::Quadric& quadric, Real tolerance) {
        const glm::dvec3 local = localPoint(quadric, glm::dvec3(position));
        const NearestFace nearest = nearestFace(quadric, local);
        if (nearest.margin < 4.0 * double(tolerance))
            return;
        Vec3 outward(hit.normal);
        EXPECT_LT(glm::dot(outward, line.direction), tolerance);
        if (quadric.kind == shared::kDisk && glm::dot(outward, Vec3(quadric.axisY)) < 0.0L)
            outward = -outward;
        const FaceAt face = faceAt(quadric, position, outward);
        EXPECT_LT(std::abs(face.distance), tolerance);
        const Real bend = face.isCurved ? tolerance / face.radius : 0.0L;
        EXPECT_LT(glm::length(face.normal - outward), 8.0L * kRoundoff + 2.0L * bend);
        const glm::dvec2 wanted = oracleCoordinates(quadric, nearest.isFlat, local);
        const double radius = nearest.isFlat ? quadric.radius : std::hypot(local.x, local.z);
        const double error = 2.0 * kAngleError + double(tolerance) / std::min(radius, 1.0);
        const double aroundU = std::abs(hit.uv.x - wanted.x);
        EXPECT_LT(std::min(aroundU, 1.0 - aroundU), error);
        EXPECT_NEAR(hit.uv.y, wanted.y, error);
    }
};

TEST_P(FirstHitQuadricTest, IsWhatTheRayThroughTheMiddleMeets) {
    RandomNumbers random(171 + std::get<0>(GetParam()));
    uint32_t shown = 0;
    constexpr int kScenes = 3;
    for (int i = 0; i < kScenes && !HasFailure(); ++i) {
        const Scene scene = randomScene(random);
        const FirstHits hits = firstHitsOf(scene);
        for (uint32_t y = 0; y < hits.image.height; ++y)
            for (uint32_t x = 0; x < hits.image.width; ++x) {
                const Line line = pixelLine(scene.camera, scene.film, x, y, hits.packed.origin);
                SCOPED_TRACE(testing::Message() << "scene " << i << ", pixel " << x << "," << y);
                shown += check(hits.image.at(x, y), line, scene.camera, hits.packed) ? 1 : 0;
            }
    }
    EXPECT_GT(shown, kScenes * 29u * 23u / 20u);
}

INSTANTIATE_TEST_SUITE_P(
    All, FirstHitQuadricTest,
    testing::Combine(testing::ValuesIn(kAllQuadricKinds),
                     testing::Values(Projection::Perspective, Projection::Orthographic)),
    [](const auto& instance) {
        const bool parallel = std::get<1>(instance.param) == Projection::Orthographic;
        return nameOf(std::get<0>(instance.param)) + (parallel ? "Orthographic" : "Perspective");
    });

} // namespace
} // namespace calotype::test
