// Floor points that lie in a lamp's plane, or nearly: the lamp is seen edge on.
#include <algorithm>

#include <glm/geometric.hpp>

#include "extremes/irradiance.h"
#include "extremes/judgement.h"
#include "extremes/lit_floor.h"
#include "math/rotation.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

class EdgeOnLightTest : public GpuTest {};
class SlowEdgeOnLightTest : public GpuTest {};

/// By how much rounding may turn the direction in which a lamp 1 m away is seen, in radians: a
/// point of a floor 6 m wide carries three roundings of 2^-24 of that, or 1.1e-6 m.
constexpr double kAngleError = 3.0 * 6.0 * 0x1p-24;

const std::vector<glm::dvec3> kLamp = {
    {0.0, 0.5, -0.5}, {0.0, 1.5, -0.5}, {0.0, 1.5, 0.5}, {0.0, 0.5, 0.5}};

/// An upright lamp in the plane x = 0, above a floor seen at x = `angle` metres, all of it turned.
Judgement judgeAt(double angle, const glm::dmat3& rotation) {
    const auto turned = [&](std::vector<glm::dvec3> corners) {
        for (glm::dvec3& corner : corners)
            corner = rotation * corner;
        return corners;
    };
    SceneBuilder builder;
    builder.polygon(turned(kLamp), builder.material(0.0, 1.0));
    builder.polygon(turned({{-3, 0, 3}, {3, 0, 3}, {3, 0, -3}, {-3, 0, -3}}),
                    builder.material(kFloorAlbedo, 0.0));
    lookDownAt(builder, angle, 0.0, 0.5, 0.01 * angle);
    Camera& camera = builder.scene().camera;
    camera.position = rotation * camera.position;
    camera.right = rotation * camera.right;
    camera.up = rotation * camera.up;
    camera.forward = rotation * camera.forward;
    builder.scene().render.maxBounces = 1;
    return judge(builder.scene(), 16, 16);
}

const glm::dmat3 kUpright(1.0);
const glm::dmat3 kTurned = rotationTakingYTo(glm::normalize(glm::dvec3(1, 2, 3)));

void expectLitAt(double angle, const glm::dmat3& rotation) {
    SCOPED_TRACE(angle);
    const Judgement judgement = judgeAt(angle, rotation);
    const double bound = std::clamp(kAngleError / angle, 1e-6, 0.5); // half of it is surely seen
    expectJudgement(judgement, bound);
    const double expected = floorRadiance(polygonIrradiance(kLamp, {angle, 0.0, 0.0}));
    EXPECT_NEAR(judgement.device.mean, expected,
                bound * expected + 4.0 * judgement.device.standardError);
}

TEST_F(EdgeOnLightTest, IsLitAsItsAngleSays) {
    expectLitAt(1e-6, kUpright);
    expectLitAt(1e-6, kTurned);
    expectLitAt(1e-4, kTurned);
}

TEST_F(SlowEdgeOnLightTest, IsLitAsItsAngleSays) {
    for (const glm::dmat3& rotation : {kUpright, kTurned})
        for (const double angle : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
            expectLitAt(angle, rotation);
}

// In the plane itself nothing arrives, but for that angle.
TEST_F(EdgeOnLightTest, IsDarkInItsPlane) {
    const double perRadian = floorRadiance(polygonIrradiance(kLamp, {1e-3, 0.0, 0.0})) / 1e-3;
    for (const glm::dmat3& rotation : {kUpright, kTurned}) {
        const Judgement judgement = judgeAt(1e-12, rotation);
        EXPECT_GE(judgement.device.mean, 0.0);
        EXPECT_LT(judgement.device.mean, kAngleError * perRadian);
    }
}

} // namespace
} // namespace calotype::test
