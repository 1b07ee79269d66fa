// Samples fall about their pixel as the film's filter says.
#include <cmath>
#include <string>

#include "kernels/film_sample.spv.h"
#include "pack/filter_table.h"
#include "pack/pack_camera.h"
#include "render/scene_buffers.h"
#include "support/chi_square.h"
#include "support/gpu_test.h"
#include "support/oracle_filter.h"
#include "support/primitive_scene.h"
#include "support/random_numbers.h"
#include "support/statistics.h"

namespace calotype::test {
namespace {

constexpr uint32_t kSamples = 1 << 19;
constexpr uint32_t kCells = 24; ///< on a side

class FilmFilterSamplingTest : public GpuTest, public testing::WithParamInterface<FilmFilter> {
protected:
    /// Offsets from the pixel's centre for points of the unit square.
    std::vector<glm::dvec2> offsets(const std::vector<glm::vec2>& points) const {
        GpuScene table;
        table.filterSteps = filterSteps(GetParam());
        const PrimitiveScene scene(std::move(table));
        const SceneBuffers buffers(testDevice(), scene.packed());
        const shared::Camera camera = packCamera(Camera{}, GetParam(), glm::dvec3(0.0), 1.0);
        std::vector<glm::vec4> inputs;
        for (const glm::vec2& u : points)
            inputs.emplace_back(u, static_cast<float>(camera.filterIsBox), 0.0f);
        std::vector<glm::dvec2> result;
        for (const glm::vec2& position :
             runKernel<glm::vec2>(kFilmSampleSpirv, inputs, buffers.bindings(), kTestInputBinding))
            result.push_back(glm::dvec2(position) - 0.5);
        return result;
    }

    std::vector<glm::dvec2> randomOffsets() const {
        RandomNumbers random(151);
        std::vector<glm::vec2> points(kSamples);
        for (glm::vec2& point : points)
            point = {random.deviceUnit(), random.deviceUnit()};
        return offsets(points);
    }

    const OracleFilter oracle_{GetParam()};
};

// In cells that all hold the same share of the filter.
TEST_P(FilmFilterSamplingTest, IsDistributedAsTheFilter) {
    std::vector<uint64_t> counts(kCells * kCells);
    const auto cellOf = [&](double x) {
        return std::min(static_cast<uint32_t>(oracle_.shareBelow(x) * kCells), kCells - 1);
    };
    for (const glm::dvec2& offset : randomOffsets())
        ++counts[cellOf(offset.y) * kCells + cellOf(offset.x)];
    const std::vector<double> chances(counts.size(), 1.0 / double(counts.size()));
    EXPECT_LT(chiSquare(counts, chances), chiSquareLimit(counts.size() - 1));
}

TEST_P(FilmFilterSamplingTest, HasTheFiltersMoments) {
    std::vector<double> x, y, xx, yy, xy;
    for (const glm::dvec2& offset : randomOffsets()) {
        x.push_back(offset.x);
        y.push_back(offset.y);
        xx.push_back(offset.x * offset.x);
        yy.push_back(offset.y * offset.y);
        xy.push_back(offset.x * offset.y);
    }
    const auto expectMean = [](const std::vector<double>& values, double wanted) {
        const Estimate found = estimate(values);
        EXPECT_NEAR(found.mean, wanted, 4.0 * found.standardError);
    };
    expectMean(x, 0.0);
    expectMean(y, 0.0);
    expectMean(xy, 0.0);
    expectMean(xx, oracle_.variance());
    expectMean(yy, oracle_.variance());
}

// From one end of the support to the other, never beyond, and never back.
TEST_P(FilmFilterSamplingTest, GoesFromEndToEnd) {
    std::vector<glm::vec2> points;
    for (uint32_t i = 0; i <= 1u << 16; ++i) {
        const float u = std::min(static_cast<float>(i) * 0x1p-16f, 1.0f - 0x1p-24f);
        points.push_back({u, 1.0f - 0x1p-24f - u});
    }
    points[1].x = 0x1p-24f;
    const auto found = offsets(points);
    constexpr double kRounding = 0x1p-22;
    for (size_t i = 0; i < found.size(); ++i) {
        for (int axis = 0; axis < 2; ++axis) {
            ASSERT_LE(std::abs(found[i][axis]), oracle_.radius()) << "u " << points[i][axis];
            // By the quantiles' definition, but for the table's steps.
            ASSERT_NEAR(oracle_.shareBelow(found[i][axis]), points[i][axis], 1.0 / 1023);
        }
        if (i > 0)
            ASSERT_GE(found[i].x, found[i - 1].x - kRounding);
    }
    EXPECT_NEAR(found.front().x, -oracle_.radius(), kRounding);
    EXPECT_NEAR(found.back().x, oracle_.radius(), 1e-4);
}

std::string filterName(FilmFilter filter) {
    constexpr const char* kNames[] = {"Box", "Tent", "Gaussian", "BlackmanHarris"};
    return kNames[static_cast<size_t>(filter)];
}

INSTANTIATE_TEST_SUITE_P(Of, FilmFilterSamplingTest,
                         testing::Values(FilmFilter::Box, FilmFilter::Tent, FilmFilter::Gaussian,
                                         FilmFilter::BlackmanHarris),
                         [](const auto& instance) { return filterName(instance.param); });

} // namespace
} // namespace calotype::test
