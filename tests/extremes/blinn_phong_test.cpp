// Blinn-Phong exponents from 0 to the largest allowed, seen and lit down to the surface's plane.
#include <iostream>

#include "extremes/lobe_errors.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

constexpr double kExponents[] = {
    0.0, 0.5, 1.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6, 3e6, Material::kHighestExponent};

Material blinnPhong(double exponent, double kd, double ks, bool normalize) {
    Material material;
    material.type = MaterialType::BlinnPhong;
    material.color = glm::dvec3(0.9);
    material.exponent = exponent;
    material.kd = kd;
    material.ks = ks;
    material.normalize = normalize;
    return material;
}

double lobeWidth(double exponent) { return std::min(1.0, std::sqrt(2.0 / (exponent + 2.0))); }

struct Parameter {
    bool normalize;
    size_t count; ///< of events on each material
};

class BlinnPhongExtremesTest : public GpuTest, public testing::WithParamInterface<Parameter> {
protected:
    static constexpr double kAllowedRoundoffs = 8.0;

    /// Samples of every exponent.
    static LobeErrors samplesOf(double kd, double ks, uint64_t seed) {
        const auto [normalize, count] = GetParam();
        RandomNumbers random(seed);
        LobeErrors errors;
        for (const SurfaceFrame frame : {SurfaceFrame::Upright, SurfaceFrame::Turned})
            for (const double exponent : kExponents)
                addSamples(blinnPhong(exponent, kd, ks, normalize), lobeWidth(exponent), frame,
                           count, random, errors);
        std::cout << errors;
        EXPECT_EQ(errors.notFinite, 0u);
        EXPECT_LE(errors.roundoffs, kAllowedRoundoffs) << errors.worst;
        EXPECT_EQ(errors.unexplained, 0u) << errors.worst;
        EXPECT_LE(errors.tipped, errors.events / 500);
        EXPECT_LE(errors.meanDifference, 1e-5);
        return errors;
    }
};

TEST_P(BlinnPhongExtremesTest, ValuesAreThoseOfDirectionsWithinRounding) {
    const auto [normalize, count] = GetParam();
    RandomNumbers random(211);
    LobeErrors errors;
    for (const double exponent : kExponents)
        for (const double kd : {0.0, 0.5})
            addValues(blinnPhong(exponent, kd, 0.4, normalize), lobeWidth(exponent), count, random,
                      errors);
    std::cout << errors;
    EXPECT_EQ(errors.notFinite, 0u);
    EXPECT_LE(errors.roundoffs, kAllowedRoundoffs) << errors.worst;
}

// Samples of the form that is not normalized weigh 4 ks (n + 2) / (n + 1) wo.h wi.z, of the
// normalized one at most ks.
TEST_P(BlinnPhongExtremesTest, LobesScatterAsTheReference) {
    EXPECT_LE(samplesOf(0.0, 1.0, 212).greatestWeight, GetParam().normalize ? 1.0 + 1e-6 : 8.0);
}

TEST_P(BlinnPhongExtremesTest, MixturesScatterAsTheReference) {
    EXPECT_LE(samplesOf(0.5, 0.4, 213).greatestWeight, GetParam().normalize ? 1.0 : 8.0);
}

void PrintTo(const Parameter& parameter, std::ostream* stream) {
    *stream << parameter.count << " events";
}

std::string nameOf(const testing::TestParamInfo<Parameter>& instance) {
    return instance.param.normalize ? "Normalized" : "AsTheReport";
}

INSTANTIATE_TEST_SUITE_P(With, BlinnPhongExtremesTest,
                         testing::Values(Parameter{false, 400}, Parameter{true, 400}), nameOf);
INSTANTIATE_TEST_SUITE_P(SlowWith, BlinnPhongExtremesTest,
                         testing::Values(Parameter{false, 2000}, Parameter{true, 2000}), nameOf);

} // namespace
} // namespace calotype::test
