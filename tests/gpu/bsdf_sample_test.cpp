// Directions drawn from every opaque material: distributed as their density says, weighted by value
// over density, and conserving energy where the scene format says so.
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "kernels/scattering.spv.h"
#include "support/chi_square.h"
#include "support/gpu_test.h"
#include "support/oracle_bsdf.h"
#include "support/random_numbers.h"
#include "support/statistics.h"
#include "support/test_materials.h"

namespace calotype::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr uint32_t kSamples = 60'000;
constexpr double kCosines[] = {1.0, 0.7, 0.25, 0.04};

/// The viewer's place, off the axes of the frame.
glm::dvec3 viewer(double cosTheta) { return directionAt(cosTheta, 0.8); }

std::vector<gpu::TestScattered> drawSamples(const TestMaterial& test, double cosThetaO,
                                            RandomNumbers& random) {
    std::vector<gpu::TestScattering> events(kSamples,
                                            scatteringOn(test.material, viewer(cosThetaO)));
    for (gpu::TestScattering& event : events) {
        event.u1 = random.deviceUnit();
        event.u2 = random.deviceUnit();
        event.u3 = random.deviceUnit();
    }
    for (size_t i = 0; i < 8; ++i) { // the ends of the numbers' range
        const auto end = [](bool upper) { return upper ? 1.0f - 0x1p-24f : 0.0f; };
        events[i].u1 = end(i & 1);
        events[i].u2 = end(i & 2);
        events[i].u3 = end(i & 4);
    }
    return runKernel<gpu::TestScattered>(kScatteringSpirv, events);
}

double mixturePdf(const TestMaterial& test, double diffuseChance, const glm::dvec3& wo,
                  const glm::dvec3& wi) {
    const double halfVector =
        diffuseChance < 1.0 ? oracleHalfVectorPdf(test.material, wo, wi) : 0.0;
    return diffuseChance * wi.z / kPi + (1.0 - diffuseChance) * halfVector;
}

/// Cells of half vectors: rings in q, where the half vector's angle to the normal is
/// width (e^q - 1), so that a narrow lobe and a diffuse one beside it both spread over the rings.
class HalfVectorCells {
public:
    static constexpr int kRings = 14;
    static constexpr int kSectors = 8;
    static constexpr int kCells = kRings * kSectors;

    HalfVectorCells(const glm::dvec3& wo, double lobeWidth)
        : wo_(wo), width_(lobeWidth), qEnd_(std::log1p(0.5 * kPi / lobeWidth)) {}

    int cellOf(const glm::dvec3& wi) const {
        const glm::dvec3 h = wo_ + wi;
        const double q = std::log1p(std::atan2(std::hypot(h.x, h.y), h.z) / width_);
        const double turns = std::atan2(h.y, h.x) / (2.0 * kPi) + 0.5;
        return std::min(static_cast<int>(q / qEnd_ * kRings), kRings - 1) * kSectors +
               std::min(static_cast<int>(turns * kSectors), kSectors - 1);
    }

    struct Integrals {
        std::vector<double> cells;
        std::vector<bool> isCut; ///< the cell reaches below the horizon, where the density jumps
    };

    /// The integral over each cell of a density of directions, which becomes one of half vectors
    /// by the Jacobian 4 wo.h.
    template <typename Density>
    Integrals integrate(const Density& pdf) const {
        constexpr int kSteps = 40;
        Integrals result{std::vector<double>(kCells), std::vector<bool>(kCells)};
        for (int i = 0; i < kRings * kSteps; ++i)
            for (int j = 0; j < kSectors * kSteps; ++j) {
                const int cell = i / kSteps * kSectors + j / kSteps;
                const double q = (i + 0.5) / (kRings * kSteps) * qEnd_;
                const double phi = ((j + 0.5) / (kSectors * kSteps) - 0.5) * 2.0 * kPi;
                const double theta = width_ * std::expm1(q);
                const glm::dvec3 h(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                   std::cos(theta));
                const double woh = glm::dot(wo_, h);
                const glm::dvec3 wi = 2.0 * woh * h - wo_;
                if (woh <= 0.0 || wi.z <= 0.0) {
                    result.isCut[cell] = true;
                    continue;
                }
                const double dq = qEnd_ / (kRings * kSteps);
                const double dPhi = 2.0 * kPi / (kSectors * kSteps);
                const double solidAngle = std::sin(theta) * width_ * std::exp(q) * dq * dPhi;
                result.cells[cell] += pdf(wi) * 4.0 * woh * solidAngle;
            }
        return result;
    }

private:
    glm::dvec3 wo_;
    double width_;
    double qEnd_;
};

/// Cells too rare for the statistic are counted together.
void poolRareCells(std::vector<uint64_t>& counts, std::vector<double>& chances) {
    constexpr double kRare = 20.0 / kSamples;
    std::vector<uint64_t> keptCounts(1);
    std::vector<double> keptChances(1);
    for (size_t i = 0; i < counts.size(); ++i) {
        if (chances[i] < kRare) {
            keptCounts[0] += counts[i];
            keptChances[0] += chances[i];
        } else {
            keptCounts.push_back(counts[i]);
            keptChances.push_back(chances[i]);
        }
    }
    if (keptChances[0] < kRare) { // still rare: with the first
        keptCounts[1] += keptCounts[0];
        keptChances[1] += keptChances[0];
        keptCounts.erase(keptCounts.begin());
        keptChances.erase(keptChances.begin());
    }
    counts = std::move(keptCounts);
    chances = std::move(keptChances);
}

class BsdfSample : public GpuTest {};

TEST_F(BsdfSample, IsDistributedAsItsDensity) {
    RandomNumbers random(81);
    for (const TestMaterial& test : testMaterials())
        for (const double cosThetaO : kCosines) {
            const glm::dvec3 wo = viewer(cosThetaO);
            const auto samples = drawSamples(test, cosThetaO, random);
            const double diffuseChance = samples[0].diffuseChance;
            const HalfVectorCells cells(wo, test.lobeWidth);
            const auto integrals = cells.integrate(
                [&](const glm::dvec3& wi) { return mixturePdf(test, diffuseChance, wo, wi); });
            std::vector<uint64_t> counts(HalfVectorCells::kCells + 1); // the last: rejected
            for (const gpu::TestScattered& sample : samples)
                ++counts[sample.pdf > 0.0f ? cells.cellOf(glm::dvec3(sample.wi))
                                           : HalfVectorCells::kCells];
            double integral = 0.0;
            for (const double cell : integrals.cells)
                integral += cell;
            // The density integrates to one, but for what falls below the surface.
            const double accepted = 1.0 - static_cast<double>(counts.back()) / kSamples;
            EXPECT_NEAR(integral, accepted, 0.008) << test.name << ", cosine " << cosThetaO;
            // A cell cut by the horizon is counted with what falls below it.
            std::vector<double> chances = integrals.cells;
            chances.push_back(1.0);
            for (size_t cell = 0; cell < integrals.cells.size(); ++cell) {
                if (integrals.isCut[cell]) {
                    counts.back() += std::exchange(counts[cell], 0);
                    chances[cell] = 0.0;
                }
                chances.back() -= chances[cell];
            }
            chances.back() = std::max(chances.back(), 0.0);
            poolRareCells(counts, chances);
            EXPECT_LT(chiSquare(counts, chances), chiSquareLimit(counts.size() - 1))
                << test.name << ", cosine " << cosThetaO;
        }
}

TEST_F(BsdfSample, WeighsValueOverDensity) {
    RandomNumbers random(82);
    for (const TestMaterial& test : testMaterials())
        for (const double cosThetaO : kCosines) {
            const glm::dvec3 wo = viewer(cosThetaO);
            for (const gpu::TestScattered& sample : drawSamples(test, cosThetaO, random)) {
                ASSERT_TRUE(std::isfinite(sample.weight.x + sample.pdf)) << test.name;
                const glm::dvec3 wi = glm::normalize(glm::dvec3(sample.wi));
                if (sample.pdf == 0.0f || wi.z < 1e-3) {
                    continue;
                }
                ASSERT_EQ(sample.pdf, sample.pdfAgain);
                const glm::dvec3 value = oracleValue(test.material, wo, wi);
                const double pdf = mixturePdf(test, sample.diffuseChance, wo, wi);
                // Rounding turns the half vector, and the shares of two lobes with it.
                const double tolerance =
                    1e-4 + 2e-5 / (test.lobeWidth * glm::length(wo + wi)) + 1e-6 / wi.z;
                ASSERT_NEAR(sample.weight.x, value.x / pdf, tolerance * value.x / pdf)
                    << test.name << ", cosines " << cosThetaO << " " << wi.z;
            }
        }
}

// The report's Blinn-Phong form reflects up to about 4 ks; every other model at most what arrives.
TEST_F(BsdfSample, ConservesEnergyWhereItShould) {
    RandomNumbers random(83);
    for (TestMaterial test : testMaterials()) {
        if (test.material.type == MaterialType::Metal)
            test.material.color = glm::dvec3(1.0);
        for (const double cosThetaO : kCosines) {
            std::vector<double> weights;
            for (const gpu::TestScattered& sample : drawSamples(test, cosThetaO, random))
                weights.push_back(sample.weight.x);
            const Estimate albedo = estimate(weights);
            if (test.conservesEnergy) {
                EXPECT_LT(albedo.mean, 1.0 + 4.0 * albedo.standardError + 1e-6)
                    << test.name << ", cosine " << cosThetaO;
            }
            if (test.material.type == MaterialType::BlinnPhong && test.material.kd == 0.0 &&
                !test.material.normalize && cosThetaO == 1.0 && test.material.exponent > 10.0) {
                EXPECT_GT(albedo.mean, 3.3 * test.material.ks) << test.name;
            }
        }
    }
}

} // namespace
} // namespace calotype::test
