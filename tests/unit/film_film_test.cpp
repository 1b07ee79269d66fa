#include "film/film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "film/block_count.h"
#include "shared/limits.h"

namespace calotype {
namespace {

constexpr float kWhole = shared::kSamplesPerBlock;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

using Block = std::vector<glm::vec4>;

void addNext(Film& film, const Block& block) {
    film.addBlock(static_cast<uint32_t>(film.blocks().count()), block);
}

Block uniformBlock(size_t pixels, const glm::vec3& sum) {
    return Block(pixels, glm::vec4(sum, kWhole));
}

TEST(FilmUnitTest, IsTheLeastPowerOfTwoThatReachesTheLight) {
    EXPECT_EQ(filmUnit(0.0), 1.0);
    EXPECT_EQ(filmUnit(1.0), 1.0);
    EXPECT_EQ(filmUnit(1.0000001), 2.0);
    EXPECT_EQ(filmUnit(20.0), 32.0);
    EXPECT_EQ(filmUnit(0.3), 0.5);
    EXPECT_EQ(filmUnit(0.25), 0.25);
    EXPECT_EQ(filmUnit(1e300), 0x1p127);
    EXPECT_EQ(filmUnit(1e-300), 0x1p-126);
}

TEST(FilmTest, StartsBlack) {
    const Film film(3, 2, 1.0);
    const Image image = film.picture();
    EXPECT_EQ(image.width, 3u);
    EXPECT_EQ(image.height, 2u);
    EXPECT_EQ(image.pixels, std::vector<glm::vec3>(6, glm::vec3(0.0f)));
    EXPECT_TRUE(film.blocks().empty());
}

TEST(FilmTest, PictureIsTheMeanOfItsSamples) {
    Film film(2, 1, 32.0);
    addNext(film, Block{{16, 32, -48, kWhole}, {0, 8, 1, kWhole}});
    addNext(film, Block{{48, 0, 16, kWhole}, {16, 8, 1, kWhole}});
    EXPECT_EQ(film.blocks().count(), 2u);
    EXPECT_EQ(film.samplesPerPixel(), 32u);
    EXPECT_EQ(film.picture().at(0, 0), glm::vec3(2, 1, -1));
    EXPECT_EQ(film.picture().at(1, 0), glm::vec3(0.5f, 0.5f, 0.0625f));
}

TEST(FilmTest, IsBitForBitTheSameInAnyOrderOfBlocks) {
    constexpr size_t kPixels = 12;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> mantissa(-1.0f, 1.0f);
    std::uniform_int_distribution<int> exponent(-70, 39);
    std::vector<Block> blocks(60, Block(kPixels));
    for (Block& block : blocks)
        for (glm::vec4& pixel : block) {
            for (int channel = 0; channel < 3; ++channel)
                pixel[channel] = std::ldexp(mantissa(random), exponent(random));
            pixel.w = kWhole;
        }
    std::vector<uint32_t> order(blocks.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto filmOf = [&](std::span<const uint32_t> indices) {
        Film film(4, 3, 1.0);
        for (const uint32_t index : indices)
            film.addBlock(index, blocks[index], {index, 1, 0, 0});
        return film;
    };
    const Film first = filmOf(order);
    EXPECT_EQ(first.losses(), (FilmLosses{60 * 59 / 2, 60, 0, 0}));
    for (int round = 0; round < 20; ++round) {
        std::shuffle(order.begin(), order.end(), random);
        const Film other = filmOf(order);
        EXPECT_TRUE(other.sums() == first.sums());
        EXPECT_EQ(other.picture().pixels, first.picture().pixels);
        // In parts of any size, joined.
        const auto cut = static_cast<size_t>(round) * 3;
        Film part = filmOf(std::span(order).first(cut));
        part.add(filmOf(std::span(order).subspan(cut)));
        EXPECT_TRUE(part.sums() == first.sums());
    }
}

TEST(FilmTest, KeepsTheLuminanceOfEachReplicaApart) {
    Film film(2, 1, 4.0);
    for (uint32_t block = 0; block < 11; ++block) {
        const auto value = static_cast<float>(block);
        film.addBlock(block, Block{{value, 0, 0, kWhole}, {0, value, 2 * value, kWhole}});
    }
    EXPECT_EQ(film.samplesOfReplica(2), 32u);
    EXPECT_EQ(film.samplesOfReplica(3), 16u);
    for (uint32_t replica = 0; replica < shared::kReplicas; ++replica) {
        const double sum = replica < 3 ? 2.0 * replica + 8.0 : replica;
        EXPECT_NEAR(film.replicaLuminance(replica, 0), 0.2126 * sum, 1e-15 * sum);
        EXPECT_NEAR(film.replicaLuminance(replica, 1), (0.7152 + 2 * 0.0722) * sum, 1e-15 * sum);
    }
}

TEST(FilmTest, DoesNotDriftOverAMillionBlocks) {
    constexpr int kBlocks = 1'000'000;
    Film film(1, 1, 4.0);
    const Block block = uniformBlock(1, {0.1f, -0.7f, 3.0f});
    for (int i = 0; i < kBlocks; ++i)
        addNext(film, block);
    // 0.1f = 13421773 * 2^-27 and 0.7f = 11744051 * 2^-24; the unit takes 2 of the 64 bits.
    const FixedPointArray& sums = film.sums().colors;
    EXPECT_TRUE(sums[0] == (FixedPoint{13421773} * kBlocks) << (64 - 27 - 2));
    EXPECT_TRUE(sums[1] == -((FixedPoint{11744051} * kBlocks) << (64 - 24 - 2)));
    EXPECT_TRUE(sums[2] == (FixedPoint{3} * kBlocks) << (64 - 2));
    EXPECT_EQ(film.picture().at(0, 0), glm::vec3(0.1f, -0.7f, 3.0f) / kWhole);
}

TEST(FilmTest, KeepsDarkPixelsBesideABrightUnit) {
    Film film(2, 1, filmUnit(1e6));
    const glm::vec3 dark(1e-6f, 3e-6f, 7e-5f); // all above 2^-41 units, which is 4.8e-7
    Block block = uniformBlock(2, dark);
    block[1] = glm::vec4(1e9f, 2e9f, 3e9f, kWhole);
    for (int i = 0; i < 1000; ++i)
        addNext(film, block);
    EXPECT_EQ(film.picture().at(0, 0), dark / kWhole);
    EXPECT_EQ(film.picture().at(1, 0), glm::vec3(block[1]) / kWhole);
}

TEST(FilmTest, RoundsBelowItsExactRangeByAtMostHalfAStep) {
    Film film(1, 1, 1.0);
    const float tiny = 0x1.234566p-60f;
    addNext(film, uniformBlock(1, glm::vec3(tiny)));
    EXPECT_LE(std::abs(fromFixedPoint(film.sums().colors[0]) - tiny), 0x1p-65);
}

TEST(FilmTest, CountsWhatIsNotFiniteAndAddsNothing) {
    Film film(4, 1, 1.0);
    addNext(film, uniformBlock(4, glm::vec3(16.0f)));
    addNext(film, Block{{NAN, 16, 16, kWhole},
                        {16, kInfinity, 16, kWhole},
                        {16, 16, -kInfinity, kWhole},
                        {16, 16, 16, kWhole}});
    EXPECT_EQ(film.losses().nonFinitePixels, 3u);
    EXPECT_EQ(film.losses().overflowedPixels, 0u);
    for (uint32_t x = 0; x < 3; ++x)
        EXPECT_EQ(film.picture().at(x, 0), glm::vec3(0.5f)) << "16 of 32 samples add zero";
    EXPECT_EQ(film.picture().at(3, 0), glm::vec3(1.0f));
}

TEST(FilmTest, CountsWhatIsOutOfRangeAndAddsNothing) {
    Film film(4, 1, 2.0);
    const float limit = 0x1p41f;
    const float below = std::nextafter(limit, 0.0f);
    addNext(film, Block{{below, -below, below, kWhole},
                        {0, limit, 0, kWhole},
                        {0, 0, -limit, kWhole},
                        {std::numeric_limits<float>::max(), 0, 0, kWhole}});
    EXPECT_EQ(film.losses().overflowedPixels, 3u);
    EXPECT_EQ(film.losses().nonFinitePixels, 0u);
    EXPECT_EQ(film.picture().at(0, 0), glm::vec3(below, -below, below) / kWhole);
    for (uint32_t x = 1; x < 4; ++x)
        EXPECT_EQ(film.picture().at(x, 0), glm::vec3(0.0f));
}

TEST(FilmDeathTest, HoldsItsLimitOfTheBrightestBlocksAndNoMore) {
    Film film(1, 1, 1.0);
    const float brightest = std::nextafter(0x1p40f, 0.0f); // (2^24 - 1) * 2^16
    const Block block = uniformBlock(1, {brightest, -brightest, 0.0f});
    for (uint64_t i = 0; i < Film::kMaxBlocks; ++i)
        addNext(film, block);
    const FixedPoint expected = FixedPoint{0xffffff} << (16 + 64 + 23);
    EXPECT_TRUE(film.sums().colors[0] == expected);
    EXPECT_TRUE(film.sums().colors[1] == -expected);
    EXPECT_DEATH(addNext(film, block), "check failed: sums_.blocks.count");
}

TEST(FilmTest, TakesTheExtremesOfUnitAndRadiance) {
    const float smallest = std::numeric_limits<float>::denorm_min();
    const float largest = std::numeric_limits<float>::max();
    Film dim(1, 1, 0x1p-126);
    addNext(dim, uniformBlock(1, {smallest, largest, 0.0f}));
    addNext(dim, uniformBlock(1, {smallest, 0.0f, 0.0f}));
    EXPECT_EQ(dim.losses().overflowedPixels, 1u);
    EXPECT_EQ(fromFixedPoint(dim.sums().colors[0]) * dim.unit(), smallest);
    Film bright(1, 1, 0x1p127);
    addNext(bright, uniformBlock(1, {largest, smallest, 0.0f}));
    EXPECT_EQ(bright.picture().at(0, 0).r, largest / kWhole);
    EXPECT_EQ(bright.losses().overflowedPixels, 0u);
}

TEST(FilmTest, ShowsAPartialBlockInThePictureOnly) {
    Film film(4, 1, 1.0);
    const Block partial = {{2, 4, 6, 2}, {8, 8, 8, 8}, {0, 0, 0, 0}, {NAN, 1, 1, 4}};
    EXPECT_EQ(film.picture(partial).pixels,
              (std::vector<glm::vec3>{{1, 2, 3}, {1, 1, 1}, {0, 0, 0}, {0, 0, 0}}));

    addNext(film, uniformBlock(4, glm::vec3(32.0f)));
    const Film::Sums before = film.sums();
    const Image image = film.picture(partial);
    EXPECT_EQ(image.at(0, 0), glm::vec3(34.0f, 36.0f, 38.0f) / 18.0f);
    EXPECT_EQ(image.at(1, 0), glm::vec3(40.0f / 24.0f));
    EXPECT_EQ(image.at(2, 0), glm::vec3(2.0f));
    EXPECT_EQ(image.at(3, 0), glm::vec3(32.0f / 20.0f));
    EXPECT_TRUE(film.sums() == before);
    EXPECT_EQ(film.blocks().count(), 1u);
    EXPECT_EQ(film.losses().nonFinitePixels, 0u);
    EXPECT_EQ(film.picture().at(1, 0), glm::vec3(2.0f));
}

// The replicas' colours are the film's own, divided among them.
TEST(FilmTest, KeepsTheColorsOfReplicas) {
    Film plain(2, 1, 4.0);
    Film film(2, 1, 4.0, ReplicaDetail::Color);
    for (const uint32_t block : {0u, 8u, 3u}) {
        const auto value = static_cast<float>(block + 1);
        const Block sums = {{16 * value, 32, 0, kWhole}, {NAN, 2, 3, kWhole}};
        plain.addBlock(block, sums);
        film.addBlock(block, sums);
    }
    EXPECT_EQ(film.picture().pixels, plain.picture().pixels);
    EXPECT_TRUE(film.sums().luminances == plain.sums().luminances);
    EXPECT_EQ(film.replicaPicture(0).pixels,
              (std::vector<glm::vec3>{{5, 2, 0}, {0, 0, 0}})); // blocks 0 and 8: 1 and 9
    EXPECT_EQ(film.replicaPicture(3).pixels, (std::vector<glm::vec3>{{4, 2, 0}, {0, 0, 0}}));
    EXPECT_EQ(film.replicaPicture(5).pixels, (std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 0}}));
    Film other(2, 1, 4.0, ReplicaDetail::Color);
    other.addBlock(11, Block{{16, 0, 0, kWhole}, {0, 0, 0, kWhole}});
    film.add(other);
    EXPECT_EQ(film.replicaPicture(3).at(0, 0), glm::vec3(2.5, 1, 0));
}

TEST(BlockCountTest, HoldsBothNumbersExactly) {
    for (uint32_t samples = 0; samples <= shared::kSamplesPerBlock; ++samples)
        for (uint32_t hidden = 0; hidden <= samples; ++hidden) {
            // As the device adds them: one sample after the other.
            float sum = 0.0f;
            for (uint32_t i = 0; i < samples; ++i)
                sum += i < hidden ? 1.0f + shared::kHiddenSample : 1.0f;
            EXPECT_EQ(blockCount({samples, hidden}), sum);
            EXPECT_EQ(blockCountOf(sum).samples, samples);
            EXPECT_EQ(blockCountOf(sum).hidden, hidden);
        }
}

// Alpha is 1 minus the share of hidden samples, and the colour's divisor is all samples.
TEST(FilmTest, AlphaIsTheShareOfSamplesThatShowASurface) {
    const auto block = [](uint32_t first, uint32_t second, uint32_t third) {
        return Block{{16, 0, 0, blockCount({16, first})},
                     {0, 8, 0, blockCount({16, second})},
                     {0, 0, 0, blockCount({16, third})}};
    };
    Film film(3, 1, 1.0, ReplicaDetail::Luminance, true);
    ASSERT_TRUE(film.hasAlpha());
    EXPECT_EQ(film.alpha(), std::vector<float>(3, 0.0f)) << "no samples";
    film.addBlock(0, block(0, 8, 16));
    Film other(3, 1, 1.0, ReplicaDetail::Luminance, true);
    other.addBlock(5, block(0, 4, 16));
    film.add(other);
    EXPECT_EQ(film.alpha(), (std::vector<float>{1.0f, 0.625f, 0.0f}));
    EXPECT_EQ(film.picture().at(0, 0).r, 1.0f);
    EXPECT_EQ(film.picture().at(1, 0).g, 0.5f) << "multiplied by alpha";
    // Eight samples more, half of them hidden in the second pixel.
    const Block partial = {{0, 0, 0, 8}, {12, 12, 12, blockCount({8, 4})}, {0, 0, 0, 8}};
    const std::vector<float> alpha = film.alpha(partial);
    EXPECT_FLOAT_EQ(alpha[1], 1.0f - 16.0f / 40.0f);
    EXPECT_FLOAT_EQ(alpha[2], 1.0f - 32.0f / 40.0f);
    EXPECT_FLOAT_EQ(film.picture(partial).at(1, 0).g, 28.0f / 40.0f);
    EXPECT_TRUE(Film(3, 1, 1.0).alpha(partial).empty());
}

TEST(FilmDeathTest, RefusesHiddenSamplesWithoutAlpha) {
    Film film(1, 1, 1.0);
    EXPECT_DEATH(film.addBlock(0, Block{{0, 0, 0, blockCount({16, 1})}}), "taken.hidden");
    EXPECT_DEATH(film.add(Film(1, 1, 1.0, ReplicaDetail::Luminance, true)), "hasAlpha");
}

TEST(FilmDeathTest, RefusesAnotherDetailThanItsOwn) {
    Film film(1, 1, 1.0, ReplicaDetail::Color);
    EXPECT_DEATH(film.add(Film(1, 1, 1.0)), "check failed: detail");
}

TEST(FilmDeathTest, RefusesBlocksThatAreNotWhole) {
    Film film(2, 1, 1.0);
    Block block = uniformBlock(2, glm::vec3(1.0f));
    block[1].w = kWhole - 1;
    EXPECT_DEATH(addNext(film, block), "check failed: taken.samples");
    EXPECT_DEATH(addNext(film, uniformBlock(1, glm::vec3(1.0f))), "check failed");
    EXPECT_DEATH(film.picture(uniformBlock(1, glm::vec3(1.0f))), "check failed");
    EXPECT_DEATH(Film(2, 1, 3.0), "check failed");
}

} // namespace
} // namespace calotype
