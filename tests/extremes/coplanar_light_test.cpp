// A lamp in the plane of the ceiling, or just below it: what it lights, and what is seen of it.
#include "extremes/judgement.h"
#include "extremes/lit_floor.h"
#include "math/rotation.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

class CoplanarLightTest : public GpuTest {};
class SlowCoplanarLightTest : public GpuTest {};

/// A black ceiling at 2 m with a lamp of 1 m `gap` metres below it, above a diffuse floor, all of
/// it turned about z.
class Room {
public:
    Room(bool isDisk, double turn, double gap)
        : rotation_(std::cos(turn), std::sin(turn), 0, -std::sin(turn), std::cos(turn), 0, 0, 0,
                    1) {
        const double y = 2.0 - gap;
        const uint32_t lamp = builder_.material(0.0, 1.0, true);
        const glm::dmat3 facingDown(1, 0, 0, 0, -1, 0, 0, 0, -1);
        if (isDisk)
            builder_.add(makeShape(
                Disk{{rotation_ * facingDown, rotation_ * glm::dvec3(0, y, 0)}, 0.5}, lamp));
        else
            polygon({{-.5, y, -.5}, {.5, y, -.5}, {.5, y, .5}, {-.5, y, .5}}, lamp);
        polygon({{-3, 2, -3}, {3, 2, -3}, {3, 2, 3}, {-3, 2, 3}}, builder_.material(0.0, 0.0));
        polygon({{-3, 0, 3}, {3, 0, 3}, {3, 0, -3}, {-3, 0, -3}},
                builder_.material(kFloorAlbedo, 0.0));
        builder_.scene().render.maxBounces = 1;
    }

    Judgement judgeFloor() { return judgeView({0.1, 1.0, 0.2}, -1.0); }
    Judgement judgeLamp() { return judgeView({0.1, 0.5, 0.2}, 1.0); }

private:
    void polygon(std::vector<glm::dvec3> corners, uint32_t material) {
        for (glm::dvec3& corner : corners)
            corner = rotation_ * corner;
        builder_.polygon(corners, material);
    }

    /// Up or down, 45 degrees wide.
    Judgement judgeView(const glm::dvec3& position, double up) {
        Camera& camera = builder_.scene().camera;
        camera.position = rotation_ * position;
        camera.forward = rotation_ * glm::dvec3(0, up, 0);
        camera.up = {0, 0, -1};
        camera.right = glm::cross(camera.forward, camera.up);
        camera.verticalFov = 0.25 * std::numbers::pi;
        return judge(builder_.scene(), 16, 8);
    }

    SceneBuilder builder_;
    glm::dmat3 rotation_;
};

// Shadow rays end before the lamp, so the ceiling takes only the light found by chance from the
// lamp's own plane.
void expectFloorIsLit(bool isDisk, double turn, double gap) {
    SCOPED_TRACE(testing::Message() << (isDisk ? "disk" : "quad") << " turned by " << turn);
    expectJudgement(Room(isDisk, turn, gap).judgeFloor(), 0.006);
}

// From a millionth of the camera's distance on, every ray separates the two.
void expectLampIsSeen(bool isDisk, double turn, double gap) {
    SCOPED_TRACE(testing::Message() << (isDisk ? "disk" : "quad") << " turned by " << turn);
    Room room(isDisk, turn, gap);
    expectJudgement(room.judgeFloor(), 5e-6);
    expectJudgement(room.judgeLamp(), 1e-6);
}

TEST_F(CoplanarLightTest, LightsTheFloorFromTheCeilingsPlane) {
    expectFloorIsLit(false, 0.0, 0.0);
    expectFloorIsLit(true, 0.3, 0.0);
}

TEST_F(CoplanarLightTest, IsSeenFromAMillionthOfTheDistance) {
    expectLampIsSeen(false, 0.3, 1.5e-6);
    expectLampIsSeen(true, 0.3, 1.5e-6);
}

TEST_F(SlowCoplanarLightTest, OfAnyKindTurnAndGap) {
    for (const bool isDisk : {false, true})
        for (const double turn : {0.0, 0.3}) {
            for (const double gap : {0.0, 1e-7})
                expectFloorIsLit(isDisk, turn, gap);
            for (const double gap : {1.5e-6, 1.5e-4})
                expectLampIsSeen(isDisk, turn, gap);
        }
}

} // namespace
} // namespace calotype::test
