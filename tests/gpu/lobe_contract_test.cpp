// The contract of bsdf/lobe.glsl, for every lobe of the closed list and on both sides of the
// surface: what is drawn, its density and its value agree.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "kernels/lobe.spv.h"
#include "support/gpu_test.h"
#include "support/random_numbers.h"
#include "support/statistics.h"
#include "support/test_materials.h"

namespace calotype::test {
namespace {

constexpr double kSphere = 4.0 * std::numbers::pi;
constexpr double kCosines[] = {0.9, 0.4, 0.1};
constexpr uint32_t kDraws = 200'000;

/// One lobe with its parameters.
struct LobeCase {
    std::string name;
    shared::TestScattering event;
};

LobeCase lobeCase(const std::string& name, uint32_t lobes, float roughness, float exponent,
                  float eta) {
    shared::TestScattering event{};
    event.material.lobes = lobes;
    event.material.color = {0.9f, 0.6f, 0.3f};
    event.material.roughness = roughness;
    event.material.specular = 0.2f;
    event.material.kd = 0.7f;
    event.material.exponent = exponent;
    event.material.eta = eta;
    return {name, event};
}

/// The closed list. Lobes are wide enough to be integrated by directions uniform on the sphere.
std::vector<LobeCase> lobeCases() {
    const uint32_t metal = shared::kLobeGgx | shared::kColorIsF0;
    return {lobeCase("Diffuse", shared::kLobeDiffuse, 0.0f, 0.0f, 1.0f),
            lobeCase("GgxSchlick", metal, 0.5f, 0.0f, 1.0f),
            lobeCase("GgxSmith", metal | shared::kSmithMasking, 1.0f, 0.0f, 1.0f),
            lobeCase("GgxOfANonmetal", shared::kLobeGgx, 0.7f, 0.0f, 1.0f),
            lobeCase("GgxMirror", metal, 0.0f, 0.0f, 1.0f),
            lobeCase("BlinnPhong", shared::kLobeBlinnPhong, 0.0f, 20.0f, 1.0f),
            lobeCase("BlinnPhongOfExponentZero", shared::kLobeBlinnPhong, 0.0f, 0.0f, 1.0f),
            lobeCase("BlinnPhongNormalized", shared::kLobeBlinnPhong | shared::kNormalizedLobe,
                     0.0f, 5.0f, 1.0f),
            lobeCase("DielectricEntered", shared::kLobeDielectric, 0.0f, 0.0f, 1.5f),
            lobeCase("DielectricLeft", shared::kLobeDielectric, 0.0f, 0.0f, 1.0f / 1.5f)};
}

/// Cells of equal solid angle; none reaches across the surface.
struct SphereCells {
    static constexpr int kBands = 12;
    static constexpr int kSectors = 8;
    static constexpr int kCells = kBands * kSectors;

    static int cellOf(const glm::vec3& w) {
        const int band = std::clamp(static_cast<int>((w.z + 1.0) / 2.0 * kBands), 0, kBands - 1);
        const double turns = std::atan2(w.y, w.x) / (2.0 * std::numbers::pi) + 0.5;
        return band * kSectors + std::min(static_cast<int>(turns * kSectors), kSectors - 1);
    }
};

using CellEstimates = std::array<Estimate, SphereCells::kCells>;

/// Mean and its standard error, by cell, of numbers that are zero in all cells but their own.
class CellSums {
public:
    void add(const glm::vec3& direction, double number) {
        const int cell = SphereCells::cellOf(direction);
        sums_[cell] += number;
        squares_[cell] += number * number;
    }

    CellEstimates estimates() const {
        CellEstimates result;
        for (size_t cell = 0; cell < result.size(); ++cell) {
            const double mean = sums_[cell] / kDraws;
            result[cell] = {mean, std::sqrt((squares_[cell] / kDraws - mean * mean) / kDraws)};
        }
        return result;
    }

private:
    std::array<double, SphereCells::kCells> sums_{};
    std::array<double, SphereCells::kCells> squares_{};
};

/// Five standard errors, and rounding where both are sums of a few numbers.
void expectSame(const CellEstimates& drawn, const CellEstimates& integrated) {
    for (size_t cell = 0; cell < drawn.size(); ++cell) {
        const double error = std::hypot(drawn[cell].standardError, integrated[cell].standardError);
        EXPECT_NEAR(drawn[cell].mean, integrated[cell].mean, 5.0 * error + 20.0 / kDraws)
            << "cell " << cell;
    }
}

class LobeContractTest : public GpuTest, public testing::WithParamInterface<LobeCase> {
protected:
    /// Draws the lobe from the viewer at that cosine; each event's own wi is uniform on the sphere.
    void draw(double cosThetaO) {
        RandomNumbers random(301);
        events_.assign(kDraws, GetParam().event);
        for (shared::TestScattering& event : events_) {
            event.wo = glm::vec3(directionAt(cosThetaO, 0.8));
            event.wi = glm::vec3(random.direction());
            event.u1 = random.deviceUnit();
            event.u2 = random.deviceUnit();
            event.u3 = random.deviceUnit();
        }
        results_ = runKernel<shared::TestLobe>(kLobeSpirv, events_);
    }

    bool isSpecular() const { return results_[0].isSpecular != 0; }

    std::vector<shared::TestScattering> events_;
    std::vector<shared::TestLobe> results_;
};

TEST_P(LobeContractTest, DrawsAsItsDensitySaysOnBothSides) {
    for (const double cosThetaO : kCosines) {
        SCOPED_TRACE(cosThetaO);
        draw(cosThetaO);
        CellSums drawn;
        CellSums integrated;
        for (size_t i = 0; i < results_.size(); ++i) {
            if (results_[i].pdf > 0.0f)
                drawn.add(results_[i].wi, 1.0);
            integrated.add(events_[i].wi, kSphere * results_[i].givenPdf);
        }
        expectSame(drawn.estimates(), integrated.estimates());
    }
}

TEST_P(LobeContractTest, SendsItsValueToBothSides) {
    for (const double cosThetaO : kCosines) {
        SCOPED_TRACE(cosThetaO);
        draw(cosThetaO);
        CellSums drawn;
        CellSums integrated;
        for (size_t i = 0; i < results_.size(); ++i) {
            if (results_[i].pdf > 0.0f)
                drawn.add(results_[i].wi, results_[i].value.x / results_[i].pdf);
            integrated.add(events_[i].wi, kSphere * results_[i].given.x);
        }
        expectSame(drawn.estimates(), integrated.estimates());
    }
}

// The sampler reaches whatever has a value.
TEST_P(LobeContractTest, HasADensityWhereverItHasAValue) {
    for (const double cosThetaO : kCosines) {
        draw(cosThetaO);
        for (const shared::TestLobe& result : results_) {
            ASSERT_TRUE(std::isfinite(result.givenPdf)) << cosThetaO;
            ASSERT_GE(std::min({result.given.x, result.given.y, result.given.z, result.givenPdf}),
                      0.0f)
                << cosThetaO;
            if (result.given.x > 0.0f)
                ASSERT_GT(result.givenPdf, 0.0f) << cosThetaO;
        }
    }
}

TEST_P(LobeContractTest, IsEitherSpecularOrHasADensity) {
    for (const double cosThetaO : kCosines) {
        draw(cosThetaO);
        for (const shared::TestLobe& result : results_) {
            ASSERT_GE(result.albedo, 0.0f);
            ASSERT_EQ(result.isSpecularSample != 0, isSpecular());
            if (isSpecular()) {
                ASSERT_EQ(result.given, glm::vec3(0.0f));
                ASSERT_EQ(result.givenPdf, 0.0f);
                ASSERT_EQ(result.pdf, 0.0f);
                ASSERT_NEAR(glm::length(result.wi), 1.0f, 1e-5f);
                // No more light than arrives, but for the solid angle beyond a boundary.
                const float eta2 = result.eta * result.eta;
                ASSERT_LE(result.specularWeight.x * eta2, 1.0f + 1e-5f);
            } else {
                ASSERT_EQ(result.specularWeight, glm::vec3(0.0f));
            }
        }
    }
}

// Directions along the surface and straight up and down give numbers.
TEST_P(LobeContractTest, IsFiniteAtTheEdgesOfBothSides) {
    std::vector<shared::TestScattering> events;
    for (const double cosThetaO : {1e-6, 1e-3, 1.0})
        for (const float cosThetaI : {-1.0f, -1e-3f, -1e-7f, 0.0f, 1e-7f, 1e-3f, 1.0f})
            for (const double phi : {0.0, 1.0, std::numbers::pi}) {
                events.push_back(GetParam().event);
                events.back().wo = glm::vec3(directionAt(cosThetaO, 0.0));
                events.back().wi = glm::vec3(directionAt(std::abs(cosThetaI), phi));
                events.back().wi.z = cosThetaI;
            }
    for (const shared::TestLobe& result : runKernel<shared::TestLobe>(kLobeSpirv, events)) {
        ASSERT_TRUE(std::isfinite(result.given.x + result.given.y + result.given.z));
        ASSERT_TRUE(std::isfinite(result.givenPdf + result.pdf + result.albedo));
    }
}

INSTANTIATE_TEST_SUITE_P(All, LobeContractTest, testing::ValuesIn(lobeCases()),
                         [](const auto& instance) { return instance.param.name; });

} // namespace
} // namespace calotype::test
