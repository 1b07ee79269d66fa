// GGX from no roughness to 1, densely about the threshold of a mirror, seen and lit down to the
// surface's plane.
#include <iostream>

#include "extremes/lobe_errors.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

/// kMirrorAlpha is the square of 0.01.
constexpr double kMirrors[] = {0.0, 1e-6, 0.005, 0.0099, 0.00999, 0.009999};
constexpr double kLobes[] = {0.010001, 0.01001, 0.0101, 0.011, 0.012, 0.015, 0.02, 0.03,
                             0.05,     0.1,     0.2,    0.4,   0.7,   0.9,   0.99, 1.0};

Material metal(double roughness, Masking masking) {
    Material material;
    material.type = MaterialType::Metal;
    material.color = glm::dvec3(1.0);
    material.roughness = roughness;
    material.masking = masking;
    return material;
}

Material nonmetal(double roughness, Masking masking, double specular) {
    Material material = metal(roughness, masking);
    material.type = MaterialType::Nonmetal;
    material.color = glm::dvec3(0.8);
    material.specular = specular;
    return material;
}

struct Parameter {
    Masking masking;
    size_t count; ///< of events on each material
};

class GgxExtremesTest : public GpuTest, public testing::WithParamInterface<Parameter> {
protected:
    static constexpr double kAllowedRoundoffs = 8.0;

    /// On materials of every roughness.
    template <typename MakeMaterial>
    static void addEverySample(const MakeMaterial& materialOf, RandomNumbers& random,
                               LobeErrors& errors) {
        for (const SurfaceFrame frame : {SurfaceFrame::Upright, SurfaceFrame::Turned}) {
            for (const double roughness : kMirrors)
                addSamples(materialOf(roughness), 1.0, frame, GetParam().count, random, errors);
            for (const double roughness : kLobes)
                addSamples(materialOf(roughness), roughness * roughness, frame, GetParam().count,
                           random, errors);
        }
    }

    static void expectNearlyTheReference(const LobeErrors& errors) {
        std::cout << errors;
        EXPECT_EQ(errors.notFinite, 0u);
        EXPECT_LE(errors.roundoffs, kAllowedRoundoffs) << errors.worst;
        EXPECT_EQ(errors.unexplained, 0u) << errors.worst;
        EXPECT_LE(errors.tipped, errors.events / 500);
        EXPECT_LE(errors.meanDifference, 1e-5);
    }
};

TEST_P(GgxExtremesTest, ValuesAreThoseOfDirectionsWithinRounding) {
    const auto [masking, count] = GetParam();
    RandomNumbers random(201);
    LobeErrors errors;
    for (const double roughness : kLobes) {
        addValues(metal(roughness, masking), roughness * roughness, count, random, errors);
        for (const double specular : {0.0, 0.04, 1.0})
            addValues(nonmetal(roughness, masking, specular), roughness * roughness, count, random,
                      errors);
    }
    std::cout << errors;
    EXPECT_EQ(errors.notFinite, 0u);
    EXPECT_LE(errors.roundoffs, kAllowedRoundoffs) << errors.worst;
}

TEST_P(GgxExtremesTest, MetalsScatterAsTheReference) {
    RandomNumbers random(202);
    LobeErrors errors;
    addEverySample([&](double roughness) { return metal(roughness, GetParam().masking); }, random,
                   errors);
    expectNearlyTheReference(errors);
    EXPECT_LE(errors.greatestWeight, 1.0 + 1e-6); // F G2 / G1
}

TEST_P(GgxExtremesTest, NonmetalsScatterAsTheReference) {
    RandomNumbers random(203);
    LobeErrors errors;
    for (const double specular : {0.0, 0.04, 1.0})
        addEverySample(
            [&](double roughness) { return nonmetal(roughness, GetParam().masking, specular); },
            random, errors);
    expectNearlyTheReference(errors);
    EXPECT_LE(errors.greatestWeight, 2.0);
}

void PrintTo(const Parameter& parameter, std::ostream* stream) {
    *stream << parameter.count << " events";
}

std::string nameOf(const testing::TestParamInfo<Parameter>& instance) {
    return instance.param.masking == Masking::Smith ? "SmithMasking" : "SchlickMasking";
}

INSTANTIATE_TEST_SUITE_P(With, GgxExtremesTest,
                         testing::Values(Parameter{Masking::Schlick, 200},
                                         Parameter{Masking::Smith, 200}),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(SlowWith, GgxExtremesTest,
                         testing::Values(Parameter{Masking::Schlick, 2000},
                                         Parameter{Masking::Smith, 2000}),
                         nameOf);

} // namespace
} // namespace calotype::test
