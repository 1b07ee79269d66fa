#include <functional>
#include <numbers>

#include <glm/geometric.hpp>

#include "gpu/kernels/warp_structs.h"
#include "kernels/warp.spv.h"
#include "support/chi_square.h"
#include "support/gpu_test.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

constexpr uint32_t kSamples = 1 << 20;
constexpr uint32_t kRings = 16;
constexpr uint32_t kSectors = 16;

/// Random points of the unit square, as the renderer draws them.
std::vector<glm::vec4> randomPoints() {
    RandomNumbers random(5);
    std::vector<glm::vec4> points(kSamples);
    for (glm::vec4& point : points)
        point = {random.deviceUnit(), random.deviceUnit(), 0.0f, 0.0f};
    return points;
}

std::vector<shared::TestWarp> warped(const std::vector<glm::vec4>& points) {
    return runKernel<shared::TestWarp>(kWarpSpirv, points);
}

/// The square's corners and edges, as far as the numbers reach.
std::vector<shared::TestWarp> warpedEnds() {
    std::vector<glm::vec4> points;
    for (const float x : {0.0f, 0x1p-24f, 0.5f, 1.0f - 0x1p-24f})
        for (const float y : {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, 1.0f - 0x1p-24f})
            points.push_back({x, y, 0.0f, 0.0f});
    return warped(points);
}

uint32_t cellOf(double x, uint32_t cells) {
    return std::min(static_cast<uint32_t>(std::max(x, 0.0) * cells), cells - 1);
}

/// Chi-square over rings (of a share in [0, 1)) times sectors, where each cell has the chance that
/// `ringChance` gives its ring, divided evenly.
void expectSpread(const std::vector<shared::TestWarp>& warps,
                  const std::function<double(const shared::TestWarp&)>& ringShare,
                  const std::function<double(const shared::TestWarp&)>& sectorShare,
                  const std::function<double(uint32_t)>& ringChance) {
    std::vector<uint64_t> counts(kRings * kSectors);
    for (const auto& warp : warps)
        ++counts[cellOf(ringShare(warp), kRings) * kSectors + cellOf(sectorShare(warp), kSectors)];
    std::vector<double> chances;
    for (uint32_t cell = 0; cell < counts.size(); ++cell)
        chances.push_back(ringChance(cell / kSectors) / kSectors);
    EXPECT_LT(chiSquare(counts, chances), chiSquareLimit(counts.size() - 1));
}

double angleShare(double x, double y) { return 0.5 + std::atan2(y, x) / (2.0 * std::numbers::pi); }

/// Chance of the ring [i, i + 1) / kRings of a variable with the distribution function x^2.
double squareChance(uint32_t ring) { return (2.0 * ring + 1.0) / (double(kRings) * kRings); }

class WarpTest : public GpuTest {};

TEST_F(WarpTest, ToDiskIsUniform) {
    expectSpread(
        warped(randomPoints()),
        [](const auto& w) { return std::hypot(w.diskAndTriangle.x, w.diskAndTriangle.y); },
        [](const auto& w) { return angleShare(w.diskAndTriangle.x, w.diskAndTriangle.y); },
        squareChance);
}

TEST_F(WarpTest, ToTriangleIsUniform) {
    // Cells that are exact in the weights: s = b1 + b2 has the distribution s^2, b2 / s is uniform.
    expectSpread(
        warped(randomPoints()),
        [](const auto& w) { return w.diskAndTriangle.z + w.diskAndTriangle.w; },
        [](const auto& w) {
            return w.diskAndTriangle.w / (w.diskAndTriangle.z + w.diskAndTriangle.w);
        },
        squareChance);
}

TEST_F(WarpTest, ToHemisphereIsByTheCosine) {
    expectSpread(
        warped(randomPoints()), [](const auto& w) { return w.hemisphere.z; },
        [](const auto& w) { return angleShare(w.hemisphere.x, w.hemisphere.y); }, squareChance);
}

TEST_F(WarpTest, StaysInItsDomainAtTheEnds) {
    for (const shared::TestWarp& warp : warpedEnds()) {
        const glm::dvec4 w(warp.diskAndTriangle);
        EXPECT_LE(std::hypot(w.x, w.y), 1.0);
        EXPECT_GE(std::min(w.z, w.w), 0.0);
        EXPECT_LE(w.z + w.w, 1.0 + 0x1p-23);
        EXPECT_GT(warp.hemisphere.z, 0.0f);
        EXPECT_NEAR(glm::length(glm::dvec3(warp.hemisphere)), 1.0, 3e-7);
        EXPECT_NEAR(warp.pdf, warp.hemisphere.z / std::numbers::pi, 1e-7);
        EXPECT_GT(warp.pdf, 0.0f);
    }
}

} // namespace
} // namespace calotype::test
