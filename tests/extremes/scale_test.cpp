// The same scene a million times smaller or larger, and moved by a million times its size, gives
// the same picture: the reference tracer's of the scene as it was.
#include <array>

#include "extremes/picture_agreement.h"
#include "extremes/scaled_scene.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

constexpr double kSize = 10.0; ///< of everyShape, metres
const glm::dvec3 kFarAway = 1e6 * kSize * glm::dvec3(1.0, -0.5, 0.7);

struct Placement {
    const char* name;
    double scale;
    glm::dvec3 offset; ///< at scale 1
};

void PrintTo(const Placement& placement, std::ostream* stream) { *stream << placement.name; }

class ScaledScene : public GpuTest, public testing::WithParamInterface<Placement> {};

TEST_P(ScaledScene, GivesTheSamePicture) {
    const auto& [name, scale, offset] = GetParam();
    const Scene scene = everyShape();
    const Scene placed = scaledAndMoved(scene, scale, scale * offset);
    expectAgreement(agreementWithReference(placed, scene, 32, 32), 1e-4, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    By, ScaledScene,
    testing::Values(Placement{"One", 1.0, {}}, Placement{"Thousandth", 1e-3, {}},
                    Placement{"Millionth", 1e-6, {}}, Placement{"Thousand", 1e3, {}},
                    Placement{"Million", 1e6, {}}, Placement{"OneFarAway", 1.0, kFarAway},
                    Placement{"MillionthFarAway", 1e-6, kFarAway},
                    Placement{"MillionFarAway", 1e6, kFarAway}),
    [](const auto& placement) { return std::string(placement.param.name); });

} // namespace
} // namespace calotype::test
