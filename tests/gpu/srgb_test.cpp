// The kernels' linear values of sRGB-encoded ones against the standard's curve.
#include <cmath>

#include "kernels/linear_from_srgb.spv.h"
#include "support/gpu_test.h"
#include "support/oracle_texture.h"

namespace calotype::test {
namespace {

/// That linearFromSrgb states.
constexpr double kDecodingError = 1.2e-6;

class LinearFromSrgbTest : public GpuTest {};

TEST_F(LinearFromSrgbTest, IsTheStandardsForEveryByteAndBetween) {
    std::vector<float> encoded;
    for (int byte = 0; byte < 256; ++byte)
        encoded.push_back(static_cast<float>(byte) / 255.0f);
    for (int word = 0; word < 65536; ++word)
        encoded.push_back(static_cast<float>(word) / 65535.0f);
    const auto linear = runKernel<float>(kLinearFromSrgbSpirv, encoded);
    double worst = 0.0;
    for (size_t i = 0; i < encoded.size(); ++i) {
        const double wanted = oracleLinearFromSrgb(encoded[i]);
        worst = std::max(worst, std::abs(linear[i] - wanted) / std::max(wanted, 1e-30));
    }
    RecordProperty("worstTimes1e9", std::to_string(worst * 1e9));
    EXPECT_LT(worst, kDecodingError);
    EXPECT_EQ(linear[0], 0.0f);
}

} // namespace
} // namespace calotype::test
