#include "engine/preview_denoiser.h"

#include <optional>

#include <gtest/gtest.h>

#include "support/paths.h"

namespace calotype::test {
namespace {

TEST(PreviewDenoiserTest, DecidesByTheTimeBefore) {
    const PictureDenoiser denoiser(DenoiserKind::Oidn, kFakeDenoiser);
    const std::optional<DenoiserFeatures> features;
    PreviewDenoiser previews(&denoiser, features, 1);
    const Image picture(64, 48);
    EXPECT_TRUE(previews.run(picture, 0.0)) << "the first";
    EXPECT_FALSE(previews.run(picture, 0.0));
    EXPECT_TRUE(previews.run(picture, 1e9));
    EXPECT_FALSE(previews.run(picture, 1e-9));
    EXPECT_FALSE(PreviewDenoiser(nullptr, features, 1).run(picture, 1e9));
}

TEST(PreviewDenoiserTest, StatesNoError) {
    const PictureDenoiser denoiser(DenoiserKind::Oidn, kFakeDenoiser);
    const std::optional<DenoiserFeatures> features;
    const auto clean = PreviewDenoiser(&denoiser, features, 1).run(Image(64, 48), 1e9);
    ASSERT_TRUE(clean);
    EXPECT_FALSE(clean->error);
    EXPECT_EQ(clean->denoiser, "Open Image Denoise 2.0.0");
}

} // namespace
} // namespace calotype::test
