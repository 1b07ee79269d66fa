#include "engine/denoising_memory.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace calotype {
namespace {

constexpr uint64_t kPixels4k = 3840 * 2160;

TEST(DenoisingMemoryTest, OfTheLibraryIsBounded) {
    const auto perPixel = [](uint64_t pixels) {
        return static_cast<double>(denoisingBytes(DenoiserKind::Oidn, pixels, 8)) /
               static_cast<double>(pixels);
    };
    EXPECT_GT(perPixel(1'000'000), 1000.0);
    EXPECT_LT(perPixel(kPixels4k), 500.0);
}

TEST(DenoisingMemoryTest, SaysWhatIsMissing) {
    EXPECT_EQ(whyNoRoom(8'000'000'000, 8'000'000'000), "");
    EXPECT_EQ(whyNoRoom(12'540'000'000, 8'000'000'000),
              "needs about 12.5 GB of memory, and 8.0 GB are available");
}

TEST(DenoisingMemoryTest, RefusesAPictureThatIsTooLarge) {
    RenderSettings settings;
    settings.crop = {0, 0, 65535, 65535}; // 5 TB
    EXPECT_NO_THROW(requireDenoisingMemory(settings, 8));
    settings.denoiser = DenoiserKind::Statistical;
    std::string problem;
    try {
        requireDenoisingMemory(settings, 8);
    } catch (const SettingError& error) {
        problem = error.problem();
    }
    EXPECT_NE(problem.find("of memory"), std::string::npos) << problem;
    EXPECT_NE(problem.find("65535 x 65535 pixels"), std::string::npos) << problem;
    settings.crop = {0, 0, 64, 64};
    EXPECT_NO_THROW(requireDenoisingMemory(settings, 8));
}

} // namespace
} // namespace calotype
