// Lamps of 1e-6, 1 and 1e6 square metres, one metre above a floor.
#include <functional>

#include "extremes/irradiance.h"
#include "extremes/judgement.h"
#include "extremes/lit_floor.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

constexpr double kPi = std::numbers::pi;
/// Axes of a frame that looks down.
const glm::dmat3 kFacingDown(1, 0, 0, 0, -1, 0, 0, 0, -1);

/// A lamp of radiance 1 whose lowest point is 1 m above the origin, and the irradiance there.
struct Lamp {
    Shape shape;
    double irradiance;
};

Shape polygon(const std::vector<glm::dvec3>& corners) {
    SceneBuilder builder;
    builder.polygon(corners, 0);
    return builder.scene().shapes.front();
}

Lamp polygonLamp(const std::vector<glm::dvec3>& corners) {
    return {polygon(corners), polygonIrradiance(corners, {})};
}

/// From a horizontal disk overhead: pi r^2 / (r^2 + 1).
double diskIrradiance(double radius) { return kPi * radius * radius / (radius * radius + 1.0); }

Lamp triangleLamp(double area) {
    const double s = std::sqrt(area);
    return polygonLamp({{-s, 1, -s / 3}, {s, 1, -s / 3}, {0, 1, 2 * s / 3}});
}

Lamp quadLamp(double area) {
    const double s = 0.5 * std::sqrt(area);
    return polygonLamp({{-s, 1, -s}, {s, 1, -s}, {s, 1, s}, {-s, 1, s}});
}

Lamp diskLamp(double area) {
    const double r = std::sqrt(area / kPi);
    return {makeShape(Disk{{kFacingDown, {0.0, 1.0, 0.0}}, r}, 0), diskIrradiance(r)};
}

/// Wholly above the horizon and overhead: pi (r / distance)^2.
Lamp sphereLamp(double area) {
    const double r = std::sqrt(area / (4.0 * kPi));
    return {makeShape(Sphere{{glm::dmat3(1.0), {0.0, 1.0 + r, 0.0}}, r}, 0),
            kPi * std::pow(r / (1.0 + r), 2.0)};
}

/// Upright and as high as wide: seen from below, it is its lower cap.
Lamp cylinderLamp(double area) {
    const double r = std::sqrt(area / (6.0 * kPi));
    return {makeShape(Cylinder{{glm::dmat3(1.0), {0.0, 1.0 + r, 0.0}}, r, 2.0 * r}, 0),
            diskIrradiance(r)};
}

/// Apex up: seen from below, it is its base.
Lamp coneLamp(double area) {
    const double r = std::sqrt(area / (kPi * (1.0 + std::sqrt(2.0))));
    return {makeShape(Cone{{glm::dmat3(1.0), {0.0, 1.0 + r, 0.0}}, -r, 1.0}, 0), diskIrradiance(r)};
}

struct LampKind {
    const char* name;
    Lamp (*make)(double area);
};
void PrintTo(const LampKind& kind, std::ostream* stream) { *stream << kind.name; }

constexpr LampKind kKinds[] = {{"Triangle", triangleLamp}, {"Quad", quadLamp},
                               {"Disk", diskLamp},         {"Sphere", sphereLamp},
                               {"Cylinder", cylinderLamp}, {"Cone", coneLamp}};

class LightAreaTest : public GpuTest, public testing::WithParamInterface<LampKind> {};

// The patch is so small that the irradiance on it changes by 1e-8 of itself; four standard errors.
TEST_P(LightAreaTest, LightsAsTheFormulaSays) {
    for (const double area : {1e-6, 1e6}) {
        SCOPED_TRACE(area);
        const Lamp lamp = GetParam().make(area);
        SceneBuilder builder;
        builder.material(0.0, 1.0);
        builder.add(lamp.shape);
        addFloor(builder, 50.0);
        lookDownAt(builder, 0.0, 0.0, 0.05, 1e-4);
        const Judgement judgement = judge(builder.scene(), 16, 16);
        expectJudgement(judgement, 2e-6);
        const double expected = floorRadiance(lamp.irradiance);
        EXPECT_NEAR(judgement.device.mean, expected,
                    4.0 * judgement.device.standardError + 2e-6 * expected);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, LightAreaTest, testing::ValuesIn(kKinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

} // namespace
} // namespace calotype::test
