// Ten thousand lights, and lights whose powers lie 1e12 apart.
#include <cmath>

#include "extremes/irradiance.h"
#include "extremes/judgement.h"
#include "extremes/lit_floor.h"
#include "kernels/choose_light.spv.h"
#include "render/scene_buffers.h"
#include "support/gpu_test.h"
#include "support/kernels/test_structs.h"
#include "support/random_numbers.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

using ManyLightsTest = GpuTest;

constexpr uint32_t kAcross = 100;

/// 100 x 100 small lamps of 1 cm^2 that look down on a floor 2 m below, of any powers.
template <typename Radiance>
Scene lampGrid(const Radiance& radiance, double& irradiance) {
    SceneBuilder builder;
    irradiance = 0.0;
    for (uint32_t i = 0; i < kAcross * kAcross; ++i) {
        const double x = 0.04 * (i % kAcross - 0.5 * (kAcross - 1));
        const double z = 0.04 * (double(i / kAcross) - 0.5 * (kAcross - 1));
        const std::vector<glm::dvec3> corners = {{x, 2, z}, {x + 0.0141, 2, z}, {x, 2, z + 0.0141}};
        const double lamp = radiance(i);
        builder.polygon(corners, builder.material(0.0, lamp, true));
        irradiance += lamp * polygonIrradiance(corners, {});
    }
    addFloor(builder, 5.0);
    lookDownAt(builder, 0.0, 0.0, 0.5, 1e-4);
    return builder.scene();
}

void expectFloor(const Scene& scene, double irradiance, size_t blocks,
                 LightChoice choice = LightChoice::Power) {
    const Judgement judgement = judge(scene, 16, blocks, choice);
    expectJudgement(judgement, 1e-5);
    const double expected = floorRadiance(irradiance);
    EXPECT_NEAR(judgement.device.mean, expected,
                4.0 * judgement.device.standardError + 1e-6 * expected);
    EXPECT_LT(judgement.device.standardError, 0.01 * expected);
}

TEST_F(ManyLightsTest, TenThousandAlikeAddUp) {
    double irradiance;
    const Scene scene = lampGrid([](uint32_t) { return 1.0; }, irradiance);
    for (const LightChoice choice : {LightChoice::Power, LightChoice::Tree})
        expectFloor(scene, irradiance, 16, choice);
}

TEST_F(ManyLightsTest, TenThousandOfPowersOverTwelveDecadesAddUp) {
    RandomNumbers random(41);
    double irradiance;
    const Scene scene =
        lampGrid([&](uint32_t) { return random.powerOfTen(-6.0, 6.0); }, irradiance);
    for (const LightChoice choice : {LightChoice::Power, LightChoice::Tree})
        expectFloor(scene, irradiance, 16, choice);
}

// The faintest of three lights is all that this floor sees: the others, 1e6 and 1e12 times as
// strong, face away. By power, hardly a light sample comes its way, but rays find it. The tree
// leaves out what faces away.
TEST_F(ManyLightsTest, TheFaintestOfThreeIsNotLost) {
    const auto square = [](double y, double half) {
        return std::vector<glm::dvec3>{
            {-half, y, -half}, {half, y, -half}, {half, y, half}, {-half, y, half}};
    };
    SceneBuilder builder;
    builder.polygon(square(1.0, 0.5), builder.material(0.0, 1e-6, true));
    for (const double radiance : {1.0, 1e6}) {
        std::vector<glm::dvec3> corners = square(1.0 + 0.1 * std::log10(10.0 * radiance), 0.5);
        std::ranges::reverse(corners);
        builder.polygon(corners, builder.material(0.0, radiance, true));
    }
    addFloor(builder, 5.0);
    lookDownAt(builder, 0.0, 0.0, 0.5, 1e-4);
    for (const LightChoice choice : {LightChoice::Power, LightChoice::Tree})
        expectFloor(builder.scene(), 1e-6 * polygonIrradiance(square(1.0, 0.5), {}), 16, choice);
}

// The device chooses by the table to the last random number: on both sides of each border between
// columns, and between a column's own numbers and its alias's. Where they lie among those that
// choose the same, with the second number, is the place on the light.
TEST_F(ManyLightsTest, EachNumberChoosesTheLightThatTheTableSays) {
    constexpr uint64_t kNumbers = uint64_t{1} << 24;
    double irradiance;
    RandomNumbers random(42);
    const GpuScene packed =
        packAsProgram(lampGrid([&](uint32_t) { return random.powerOfTen(-6.0, 6.0); }, irradiance))
            .packed;
    const uint64_t count = packed.lightCount;
    ASSERT_EQ(count, kAcross * kAcross);
    std::vector<shared::TestChoiceQuery> queries;
    std::vector<shared::TestLightChoice> expected;
    const auto add = [&](uint64_t number, uint32_t light, double within, uint64_t first,
                         uint64_t run) {
        const float u = static_cast<float>(number) * 0x1p-24f;
        queries.push_back({{}, 0, {}, packed.lightCount, {u, float(within)}, shared::kNone, 0});
        const double place = (double(number - first) + within) / double(run);
        const float probability = packed.lights[light].selectionProbability;
        expected.push_back({light, float(place), probability, probability, 0.0f, 0, 0, 0});
    };
    for (uint64_t column = 0; column < count; ++column) {
        const uint64_t first = (column * kNumbers + count - 1) / count;
        const uint64_t end = ((column + 1) * kNumbers + count - 1) / count;
        const shared::Light& light = packed.lights[column];
        const uint64_t border = first + light.ownNumbers;
        ASSERT_LE(border, end);
        for (const double within : {0.0, 0.75}) {
            for (const uint64_t number : {first, border - 1})
                if (first < border)
                    add(number, uint32_t(column), within, first, border - first);
            for (const uint64_t number : {border, end - 1})
                if (border < end)
                    add(number, light.alias, within, border, end - border);
        }
    }
    const SceneBuffers buffers(testDevice(), packed);
    const auto choices = runKernel<shared::TestLightChoice>(kChooseLightSpirv, queries,
                                                            buffers.bindings(), kTestInputBinding);
    for (size_t i = 0; i < choices.size(); ++i) {
        ASSERT_EQ(choices[i].light, expected[i].light) << i;
        ASSERT_LT(choices[i].u, 1.0f);
        ASSERT_NEAR(choices[i].u, expected[i].u, 1e-6f) << i;
        ASSERT_EQ(choices[i].probability, expected[i].probability) << i;
        ASSERT_EQ(choices[i].probabilityForMis, expected[i].probability) << i;
    }
}

} // namespace
} // namespace calotype::test
