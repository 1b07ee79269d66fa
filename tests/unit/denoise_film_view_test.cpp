// What denoisers get of a film, even or adaptive.
#include "denoise/film_view.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "denoise/denoiser.h"

namespace calotype::test {
namespace {

constexpr uint32_t kWidth = 6;
constexpr uint32_t kHeight = 4;
constexpr size_t kPixels = kWidth * kHeight;
constexpr float kSamples = shared::kSamplesPerBlock;

class Identity : public Denoiser {
public:
    std::string name() const override { return "identity"; }
    Image run(const NoisyImage& noisy) override { return noisy.color; }
};

std::vector<glm::vec4> blockOf(uint32_t block) {
    std::mt19937 random(block);
    std::uniform_real_distribution<float> value(0.0f, 30.0f);
    std::vector<glm::vec4> sums(kPixels);
    for (glm::vec4& sum : sums)
        sum = {value(random), value(random), value(random), kSamples};
    return sums;
}

/// Pixel p has the first 4 + p % 5 blocks of half 0, and 4 + p % 3 of half 1.
uint32_t blocksIn(size_t pixel, uint32_t half) {
    return 4 + static_cast<uint32_t>(pixel % (half == 0 ? 5 : 3));
}

AdaptiveFilm unevenFilm() {
    AdaptiveFilm film(kWidth, kHeight, 1.0, ReplicaDetail::Color);
    for (uint32_t block = 0; block < 16; ++block) {
        std::vector<uint8_t> isLeftOut(kPixels);
        for (size_t i = 0; i < kPixels; ++i)
            isLeftOut[i] = block / 2 < blocksIn(i, block % 2) ? 0 : 1;
        film.addBlock(block, blockOf(block), isLeftOut);
    }
    return film;
}

void expectNear(const Image& a, const Image& b) {
    for (size_t i = 0; i < kPixels; ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(a.pixels[i][c], b.pixels[i][c], 2e-6f) << i;
}

// Each replica: the mean of its blocks in each pixel, from the blocks themselves.
TEST(FilmViewTest, HasTheReplicasOfAnAdaptiveFilm) {
    const AdaptiveFilm film = unevenFilm();
    const FilmView view(film);
    ASSERT_TRUE(view.hasEnoughReplicas());
    const std::vector<ReplicaPicture> replicas = view.replicas();
    ASSERT_EQ(replicas.size(), size_t{shared::kReplicas});
    uint64_t samples = 0;
    for (uint32_t r = 0; r < shared::kReplicas; ++r) {
        EXPECT_EQ(replicas[r].group, r % 2);
        for (size_t i = 0; i < kPixels; ++i) {
            glm::dvec3 sum(0.0);
            uint32_t count = 0;
            for (uint32_t block = r; block / 2 < blocksIn(i, block % 2); block += 8, ++count)
                sum += glm::dvec3(blockOf(block)[i]);
            const double samplesOfPixel = count * double{kSamples};
            EXPECT_EQ(replicas[r].samplesIn(i), samplesOfPixel) << r;
            EXPECT_NEAR(replicas[r].mean.pixels[i].g, sum.g / samplesOfPixel, 1e-6) << r;
            samples += count * shared::kSamplesPerBlock;
        }
    }
    EXPECT_EQ(view.samples(), samples);
    EXPECT_EQ(view.samplesPerPixel(), samples / kPixels);
}

// Without a denoiser the picture is that of the film: the halves' means have equal weights,
// whatever their samples.
TEST(FilmViewTest, ReplicasHaveTheMeanOfTheirFilm) {
    Identity identity;
    const AdaptiveFilm adaptive = unevenFilm();
    expectNear(denoise(FilmView(adaptive).replicas(), identity).color, adaptive.picture());
    Film even(kWidth, kHeight, 1.0, ReplicaDetail::Color);
    for (uint32_t block = 0; block < 11; ++block)
        even.addBlock(block, blockOf(block));
    const FilmView view(even);
    EXPECT_EQ(view.samples(), 11 * 16 * kPixels);
    EXPECT_EQ(view.samplesPerPixel(), 11u * 16u);
    EXPECT_EQ(view.replicas()[3].group, 0u);
    expectNear(denoise(view.replicas(), identity).color, even.picture());
}

// Three replicas of each group, in every pixel.
TEST(FilmViewTest, SaysWhetherThereAreEnoughReplicas) {
    Film even(kWidth, kHeight, 1.0, ReplicaDetail::Color);
    EXPECT_EQ(FilmView(even).leastSamples(), 48u);
    for (uint32_t block = 0; block < 3; ++block) {
        EXPECT_FALSE(FilmView(even).hasEnoughReplicas());
        even.addBlock(block, blockOf(block));
    }
    EXPECT_TRUE(FilmView(even).hasEnoughReplicas());
    AdaptiveFilm adaptive(kWidth, kHeight, 1.0, ReplicaDetail::Color);
    EXPECT_EQ(FilmView(adaptive).leastSamples(), 96u);
    std::vector<uint8_t> isLeftOut(kPixels);
    for (uint32_t block = 0; block < 6; ++block) {
        EXPECT_FALSE(FilmView(adaptive).hasEnoughReplicas());
        isLeftOut[5] = block == 5 ? 1 : 0;
        adaptive.addBlock(block, blockOf(block), isLeftOut);
    }
    EXPECT_FALSE(FilmView(adaptive).hasEnoughReplicas()) << "one pixel lacks a block";
    EXPECT_EQ(FilmView(adaptive).replicas().size(), 5u);
    for (uint8_t& leftOut : isLeftOut)
        leftOut = leftOut == 0 ? 1 : 0;
    adaptive.addBlock(5, blockOf(5), isLeftOut);
    EXPECT_TRUE(FilmView(adaptive).hasEnoughReplicas());
}

} // namespace
} // namespace calotype::test
