// Films with more samples in some pixels, and how these are dealt out.
#include "film/adaptive_film.h"

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "film/allocate_blocks.h"
#include "film/block_count.h"
#include "film/error_estimate.h"

namespace calotype::test {
namespace {

using Block = std::vector<glm::vec4>;

constexpr auto kSamples = static_cast<float>(shared::kSamplesPerBlock);

Block randomBlock(size_t pixels, std::mt19937& random) {
    std::uniform_real_distribution<float> unit;
    Block block(pixels);
    for (glm::vec4& sum : block)
        sum = {unit(random), unit(random), unit(random), kSamples};
    return block;
}

// With as many samples in every pixel it is a film like any other.
TEST(AdaptiveFilmTest, IsAFilmWhereAllPixelsHaveAsManySamples) {
    constexpr uint32_t kBlocks = 16;
    std::mt19937 random(3);
    Film even(5, 3, 1.0);
    AdaptiveFilm adaptive(5, 3, 1.0);
    const std::vector<uint8_t> all(15, 0);
    for (uint32_t block = 0; block < kBlocks; ++block) {
        const Block sums = randomBlock(15, random);
        even.addBlock(block, sums);
        adaptive.addBlock(block, sums, all);
    }
    EXPECT_EQ(adaptive.samples(), 15u * even.samplesPerPixel());
    const Image a = even.picture();
    const Image b = adaptive.picture();
    for (size_t i = 0; i < a.pixels.size(); ++i) {
        EXPECT_NEAR(a.pixels[i].r, b.pixels[i].r, 1e-7f);
        EXPECT_NEAR(a.pixels[i].b, b.pixels[i].b, 1e-7f);
        for (uint32_t replica = 0; replica < shared::kReplicas; ++replica) {
            EXPECT_EQ(adaptive.samplesOfReplica(replica, i), even.samplesOfReplica(replica));
            EXPECT_EQ(adaptive.replicaLuminance(replica, i), even.replicaLuminance(replica, i));
        }
    }
    // Spreads about each half's mean, not about the mean of both: 6 degrees of freedom of 7.
    EXPECT_NEAR(estimateError(adaptive)->relative / estimateError(even)->relative, 1.0, 0.15);
}

// As the colour is, so that both are of the same samples.
TEST(AdaptiveFilmTest, AlphaIsTheMeanOfItsHalves) {
    AdaptiveFilm film(2, 1, 1.0, ReplicaDetail::Luminance, true);
    const auto block = [](uint32_t first, uint32_t second) {
        return Block{{0, 0, 0, blockCount({16, first})}, {0, 0, 0, blockCount({16, second})}};
    };
    EXPECT_EQ(film.alpha(), std::vector<float>(2, 0.0f));
    film.addBlock(0, block(4, 16), std::vector<uint8_t>{0, 0});
    film.addBlock(1, block(8, 16), std::vector<uint8_t>{0, 0});
    EXPECT_EQ(film.alpha(), (std::vector<float>{0.625f, 0.0f}));
    film.addBlock(2, block(16, 0), std::vector<uint8_t>{0, 1}); // the second pixel is left out
    EXPECT_EQ(film.alpha(), (std::vector<float>{0.5f * (0.375f + 0.5f), 0.0f}));
    const Block partial = {{0, 0, 0, blockCount({16, 0})}, {0, 0, 0, blockCount({16, 0})}};
    EXPECT_EQ(film.alpha(1, partial, std::vector<uint8_t>{0, 1}),
              (std::vector<float>{0.5f * (0.375f + 0.75f), 0.0f}));
    EXPECT_TRUE(AdaptiveFilm(2, 1, 1.0).alpha().empty());
}

TEST(AdaptiveFilmTest, IsTheMeanOfItsHalves) {
    AdaptiveFilm film(2, 1, 1.0);
    const auto block = [](float first, float second) {
        return Block{{first * kSamples, 0, 0, kSamples}, {second * kSamples, 0, 0, kSamples}};
    };
    film.addBlock(0, block(1.0f, 5.0f), std::vector<uint8_t>{0, 0});
    EXPECT_EQ(film.picture().pixels[1].r, 5.0f) << "of the half that has samples";
    film.addBlock(1, block(2.0f, 7.0f), std::vector<uint8_t>{0, 0});
    film.addBlock(2, block(4.0f, 99.0f), std::vector<uint8_t>{0, 1});
    EXPECT_EQ(film.blocksOf(0)[0], 2u);
    EXPECT_EQ(film.blocksOf(0)[1], 1u);
    EXPECT_EQ(film.samples(), 5 * shared::kSamplesPerBlock);
    const Image picture = film.picture();
    EXPECT_FLOAT_EQ(picture.pixels[0].r, 0.5f * ((1.0f + 4.0f) / 2.0f + 2.0f));
    EXPECT_FLOAT_EQ(picture.pixels[1].r, 0.5f * (5.0f + 7.0f));
    // A quarter of a block more of the first pixel.
    const Block begun = {{8.0f * 4.0f, 0, 0, 4.0f}, {0, 0, 0, kSamples}};
    const Image preview = film.picture(1, begun, std::vector<uint8_t>{0, 1});
    EXPECT_FLOAT_EQ(preview.pixels[0].r, 0.5f * (2.5f + (2.0f * 16.0f + 8.0f * 4.0f) / 20.0f));
    EXPECT_EQ(preview.pixels[1], picture.pixels[1]);
}

TEST(AdaptiveFilmTest, KeepsWhatAHalfHadFoundOfAsManySamples) {
    AdaptiveFilm film(1, 1, 1.0);
    const std::vector<uint8_t> in = {0};
    const auto addGrey = [&](uint32_t block, float mean) {
        film.addBlock(block, Block{glm::vec4(glm::vec3(mean * kSamples), kSamples)}, in);
    };
    for (uint32_t i = 0; i < 8; ++i) {
        addGrey(2 * i, i < 4 ? static_cast<float>(i) : 100.0f);
        addGrey(2 * i + 1, 1.0f);
    }
    const SurveyPixel first = film.survey(0, 0)[0];
    EXPECT_FLOAT_EQ(first.mean, 1.5f); // of 0, 1, 2, 3
    EXPECT_FLOAT_EQ(first.variance, 5.0f / (3.0f * 4.0f));
    const SurveyPixel second = film.survey(0, 1)[0];
    EXPECT_FLOAT_EQ(second.mean, 50.75f); // of 50, 50.5, 51, 51.5
    EXPECT_FLOAT_EQ(second.variance, 1.25f / (3.0f * 4.0f));
    EXPECT_FLOAT_EQ(film.survey(1, 0)[0].variance, 0.0f);
}

/// Error bars of a mean of two halves with unlike numbers of samples: a normal variable's, drawn
/// many times, lies within its interval 95 times in a hundred.
TEST(AdaptiveFilmTest, IntervalsHoldOfUnlikeHalves) {
    constexpr uint32_t kPixels = 40000;
    AdaptiveFilm film(kPixels, 1, 1.0);
    const std::vector<uint8_t> in(kPixels, 0);
    std::mt19937 random(8);
    std::normal_distribution<float> noise(16.0f, 4.0f);
    for (uint32_t block = 0; block < 56; ++block) {
        if (block % 2 == 1 && block > 8)
            continue; // 28 blocks of one half, 4 of the other
        Block sums(kPixels);
        for (glm::vec4& sum : sums)
            sum = glm::vec4(glm::vec3(noise(random)), kSamples);
        film.addBlock(block, sums, in);
    }
    const std::vector<PixelError> errors = pixelErrors(film);
    const Image picture = film.picture();
    double within = 0.0;
    for (uint32_t i = 0; i < kPixels; ++i)
        within += std::abs(picture.pixels[i].g - 1.0f) <= errors[i].interval ? 1.0 / kPixels : 0.0;
    EXPECT_NEAR(within, 0.95, 0.01);
    const double truth = 0.5 * 4.0 / kSamples * std::sqrt(1.0 / 28.0 + 1.0 / 4.0);
    EXPECT_NEAR(estimateError(film)->relative / 1.96, truth, 0.02 * truth);
}

TEST(AllocateBlocksTest, FollowsTheNoise) {
    constexpr uint32_t kWidth = 40;
    // Two flat halves, apart by more than the smoothing reaches but for the seam.
    std::vector<SurveyPixel> survey;
    for (uint32_t i = 0; i < kWidth * 20; ++i)
        survey.push_back({1.0f, i % kWidth < kWidth / 2 ? 0.01f : 0.09f});
    const std::vector<uint32_t> least(survey.size(), 2);
    const auto blocks = allocateBlocks(survey, kWidth, least, 1000, 40 * survey.size());
    const double total = std::accumulate(blocks.begin(), blocks.end(), 0.0);
    EXPECT_NEAR(total / static_cast<double>(survey.size()), 40.0, 0.5);
    EXPECT_NEAR(blocks[0], 20.0, 1.0) << "a third of the other's standard deviation";
    EXPECT_NEAR(blocks[kWidth - 1], 60.0, 1.5);
    // Twice as bright: half the relative error.
    for (SurveyPixel& pixel : survey)
        pixel = {pixel.variance > 0.05f ? 2.0f : 1.0f, 0.04f};
    const auto brighter = allocateBlocks(survey, kWidth, least, 1000, 30 * survey.size());
    EXPECT_NEAR(brighter[0], 40.0, 1.0);
    EXPECT_NEAR(brighter[kWidth - 1], 20.0, 1.0);
}

TEST(AllocateBlocksTest, KeepsItsBounds) {
    std::vector<SurveyPixel> survey(100, {1.0f, 0.0f});
    survey[55].variance = 100.0f;
    std::vector<uint32_t> least(100, 3);
    least[7] = 500;
    const auto blocks = allocateBlocks(survey, 10, least, 64, 2500);
    for (size_t i = 0; i < blocks.size(); ++i) {
        EXPECT_GE(blocks[i], least[i]);
        EXPECT_LE(blocks[i], std::max(64u, least[i]));
    }
    EXPECT_EQ(blocks[7], 500u);
    EXPECT_GT(blocks[55], 3u);
    EXPECT_EQ(allocateBlocks(survey, 10, least, 64, 10), least) << "requires more than there is";
}

// Little noise to be seen does not mean that there is none: all samples are dealt out.
TEST(AllocateBlocksTest, DealsOutAll) {
    std::vector<SurveyPixel> survey(100, {1.0f, 0.0f});
    const std::vector<uint32_t> least(100, 3);
    EXPECT_EQ(allocateBlocks(survey, 10, least, 64, 2000), std::vector<uint32_t>(100, 20));
    survey[55].variance = 100.0f;
    const auto blocks = allocateBlocks(survey, 10, least, 30, 4000);
    EXPECT_NEAR(std::accumulate(blocks.begin(), blocks.end(), 0.0), 4000.0, 50.0);
    EXPECT_GT(blocks[55], blocks[0]);
    for (SurveyPixel& pixel : survey)
        pixel = {0.0f, 0.0f};
    EXPECT_EQ(allocateBlocks(survey, 10, least, 64, 5000), std::vector<uint32_t>(100, 50));
}

} // namespace
} // namespace calotype::test
