// Lamps that touch the floor that they light.
#include "extremes/irradiance.h"
#include "extremes/judgement.h"
#include "extremes/lit_floor.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

using TouchingLightTest = GpuTest;

constexpr double kAreas[] = {1e-6, 1e6};

/// A ring's worth of floor at `x` from the point of contact, below the bulge of what touches there.
void lookBeside(SceneBuilder& builder, double x, double height) {
    lookDownAt(builder, x, 0.0, height, 0.1 * x);
}

// A sphere above the plane that it touches shows itself wholly: E = pi L cos theta (r / d)^2. Where
// the floor is nearer to the contact than 1.2e-3 radii, it lies within the sphere's rounding: that
// limit is in tests/extremes/README.md, and can be seen only from below.
TEST_F(TouchingLightTest, SphereOnTheFloor) {
    for (const double area : kAreas)
        for (const double share : {2e-3, 0.5}) {
            SCOPED_TRACE(testing::Message() << area << " m^2, at " << share << " radii");
            const double r = std::sqrt(area / (4.0 * std::numbers::pi));
            SceneBuilder builder;
            builder.add(makeShape(Sphere{{glm::dmat3(1.0), {0.0, r, 0.0}}, r},
                                  builder.material(0.0, 1.0, true)));
            addFloor(builder, 10.0 * r);
            lookBeside(builder, share * r, 0.25 * share * share * r);
            const Judgement judgement = judge(builder.scene(), 16, 8);
            expectJudgement(judgement, 2e-6);
            const double expected = 0.5 * std::pow(1.0 + share * share, -1.5);
            EXPECT_NEAR(judgement.device.mean, expected,
                        4.0 * judgement.device.standardError + 1e-3 * expected);
        }
}

// On its side a cylinder touches along a line, upright with a cap; a cone with its apex or base.
TEST_F(TouchingLightTest, CylindersAndConesOnTheFloor) {
    const glm::dmat3 lying(0, 1, 0, 0, 0, 1, 1, 0, 0); // axis along z
    for (const double area : kAreas) {
        const double r = std::sqrt(area / (6.0 * std::numbers::pi));
        const RigidTransform above{glm::dmat3(1.0), {0.0, r, 0.0}};
        const std::vector<std::pair<std::string, Shape>> shapes = {
            {"lying cylinder", makeShape(Cylinder{{lying, {0.0, r, 0.0}}, r, 2.0 * r}, 0)},
            {"upright cylinder", makeShape(Cylinder{above, r, 2.0 * r}, 0)},
            {"cone on its apex", makeShape(Cone{{}, r, 1.0}, 0)},
            {"cone on its base", makeShape(Cone{above, -r, 1.0}, 0)},
        };
        for (const auto& [name, shape] : shapes) {
            SCOPED_TRACE(testing::Message() << name << " of " << area << " m^2");
            SceneBuilder builder;
            builder.material(0.0, 1.0);
            builder.add(shape);
            addFloor(builder, 10.0 * r);
            const bool standsOnFace = name.starts_with("upright") || name.ends_with("base");
            const double x = standsOnFace ? 1.01 * r : 0.01 * r;
            lookDownAt(builder, x, 0.0, 1e-5 * r, 0.001 * r);
            expectJudgement(judge(builder.scene(), 16, 8), 1e-5);
        }
    }
}

/// Of the light on the floor within a hundredth of a lamp's size of its foot. Rays that start
/// within 1.2e-5 of a triangle's size of it count as leaving it: a strip of 1.2e-3 of that square.
constexpr double kFootLoss = 1.2e-3;

// A lamp stands on the floor; the square of floor begins at its foot.
TEST_F(TouchingLightTest, UprightQuadOnTheFloor) {
    for (const double area : kAreas) {
        SCOPED_TRACE(area);
        const double s = std::sqrt(area);
        const std::vector<glm::dvec3> corners = {
            {-0.5 * s, 0, 0}, {0.5 * s, 0, 0}, {0.5 * s, s, 0}, {-0.5 * s, s, 0}};
        SceneBuilder builder;
        builder.polygon(corners, builder.material(0.0, 1.0, true));
        addFloor(builder, 10.0 * s);
        const double side = 0.01 * s;
        lookDownAt(builder, 0.0, 0.5 * side, 0.5 * side, side);
        const Judgement judgement = judge(builder.scene(), 16, 32);
        expectJudgement(judgement, kFootLoss);
        // The mean over the square, by the midpoint rule.
        constexpr int kSteps = 64;
        double irradiance = 0.0;
        for (int i = 0; i < kSteps; ++i)
            for (int j = 0; j < kSteps; ++j)
                irradiance += polygonIrradiance(corners, {((i + 0.5) / kSteps - 0.5) * side, 0.0,
                                                          (j + 0.5) / kSteps * side}) /
                              (kSteps * kSteps);
        const double expected = floorRadiance(irradiance);
        EXPECT_NEAR(judgement.device.mean, expected,
                    4.0 * judgement.device.standardError + kFootLoss * expected);
    }
}

// A lamp that lies in the floor, and shines both ways, sends it nothing; what the offset of the
// floor's points makes of that is below 1e-6 of the lamp's radiance.
TEST_F(TouchingLightTest, LampInTheFloorDoesNotLightIt) {
    for (const double area : kAreas) {
        SCOPED_TRACE(area);
        const double r = std::sqrt(area / std::numbers::pi);
        SceneBuilder builder;
        builder.add(makeShape(Disk{{}, r}, builder.material(0.0, 1.0)));
        addFloor(builder, 10.0 * r);
        lookDownAt(builder, 1.5 * r, 0.0, r, 0.9 * r);
        const Judgement judgement = judge(builder.scene(), 16, 8);
        EXPECT_LT(judgement.device.mean, 1e-6);
        EXPECT_EQ(judgement.reference.mean, 0.0);
    }
}

} // namespace
} // namespace calotype::test
