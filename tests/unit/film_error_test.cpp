// The error of a film from its replicas' spread, against its formula, against closed forms, and
// where it has to doubt itself.
#include "film/error_estimate.h"
#include "film/film.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "math/luminance.h"

namespace calotype::test {
namespace {

using Block = std::vector<glm::vec4>;

constexpr auto kSamples = static_cast<float>(shared::kSamplesPerBlock);

/// A film of grey pixels: means[b][p] is the luminance that block b finds in pixel p.
Film greyFilm(const std::vector<std::vector<double>>& means) {
    Film film(static_cast<uint32_t>(means[0].size()), 1, 1.0);
    for (uint32_t block = 0; block < means.size(); ++block) {
        Block sums;
        for (const double mean : means[block])
            sums.push_back(glm::vec4(glm::vec3(static_cast<float>(mean) * kSamples), kSamples));
        film.addBlock(block, sums);
    }
    return film;
}

TEST(ErrorEstimateTest, IsUnknownOfFewerThanTwoReplicas) {
    EXPECT_FALSE(estimateError(Film(2, 1, 1.0)));
    const Film film = greyFilm({{1.0, 2.0}});
    EXPECT_FALSE(estimateError(film));
    EXPECT_EQ(pixelErrors(film)[0].standardError, std::numeric_limits<float>::infinity());
    EXPECT_EQ(pixelErrors(film)[1].interval, std::numeric_limits<float>::infinity());
}

// Two pixels, two replicas: deviations of 0.25 about 1, and of 0.5 about 3.
TEST(ErrorEstimateTest, IsItsFormula) {
    const auto estimate = estimateError(greyFilm({{0.75, 2.5}, {1.25, 3.5}}));
    ASSERT_TRUE(estimate);
    const double floor = std::pow(0.01 * 2.0, 2.0);
    const double first = 0.25 * 0.25 / (1.0 + floor); // squared deviations 2 d^2 over 2 (2 - 1)
    const double second = 0.5 * 0.5 / (9.0 + floor);
    EXPECT_NEAR(estimate->relative, 1.96 * std::sqrt(0.5 * (first + second)), 1e-12);
    EXPECT_EQ(estimate->replicas, 2u);
    EXPECT_FALSE(estimate->doubt);
    EXPECT_FALSE(estimate->isTrusted()) << "two replicas are too few";
}

TEST(ErrorEstimateTest, WeighsReplicasByTheirSamples) {
    // Replicas 0 and 1 have two blocks, the others one.
    const std::vector<double> means = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 3.0, 4.0};
    std::vector<std::vector<double>> blocks;
    for (const double mean : means)
        blocks.push_back({mean});
    const double mean = std::accumulate(means.begin(), means.end(), 0.0) / 10.0;
    double squares = 2.0 * (std::pow(2.0 - mean, 2.0) + std::pow(3.0 - mean, 2.0));
    for (size_t i = 2; i < 8; ++i)
        squares += std::pow(means[i] - mean, 2.0);
    const double variance = squares / (7.0 * 10.0);
    const PixelError error = pixelErrors(greyFilm(blocks))[0];
    EXPECT_NEAR(error.standardError, std::sqrt(variance), 1e-6);
    EXPECT_NEAR(error.interval, 2.3646 * std::sqrt(variance), 1e-3);
}

/// Student's t distribution function, integrated by the trapezium rule.
double studentProbabilityWithin(double t, double freedom) {
    constexpr int kSteps = 20000;
    const double scale = std::exp(std::lgamma(0.5 * (freedom + 1.0)) - std::lgamma(0.5 * freedom)) /
                         std::sqrt(freedom * std::numbers::pi);
    const auto density = [&](double x) {
        return scale * std::pow(1.0 + x * x / freedom, -0.5 * (freedom + 1.0));
    };
    double sum = 0.5 * (density(0.0) + density(t));
    for (int i = 1; i < kSteps; ++i)
        sum += density(t * i / kSteps);
    return 2.0 * sum * t / kSteps;
}

TEST(ErrorEstimateTest, IntervalsAreStudents) {
    for (uint32_t replicas = 2; replicas <= shared::kReplicas; ++replicas) {
        std::vector<std::vector<double>> blocks;
        for (uint32_t block = 0; block < replicas; ++block)
            blocks.push_back({1.0 + block});
        const PixelError error = pixelErrors(greyFilm(blocks))[0];
        const double t = error.interval / error.standardError;
        EXPECT_NEAR(studentProbabilityWithin(t, replicas - 1.0), 0.95, 1e-4) << replicas;
    }
}

/// `pixels` of normally distributed block means about 1, of `spread` per replica.
Film noisyFilm(size_t pixels, double spread, uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(1.0, spread);
    std::vector<std::vector<double>> blocks(shared::kReplicas, std::vector<double>(pixels));
    for (auto& block : blocks)
        for (double& mean : block)
            mean = normal(random);
    return greyFilm(blocks);
}

// The noise is known: 0.1 per replica, 0.1 / sqrt(8) of the mean.
TEST(ErrorEstimateTest, FindsTheNoiseThatIsThere) {
    const double expected = 1.96 * 0.1 / std::sqrt(8.0);
    const auto estimate = estimateError(noisyFilm(4000, 0.1, 1));
    ASSERT_TRUE(estimate);
    // Of 4000 pixels with 7 degrees of freedom: a standard error of 0.6 %.
    EXPECT_NEAR(estimate->relative, expected, 0.03 * expected);
    // Squares of estimates with 7 degrees of freedom are 1 + 2 / 7 times too large in the mean.
    EXPECT_NEAR(estimate->uncertainty, std::sqrt(2.0 / 7.0 / 4000.0 * 9.0 / 7.0),
                0.05 * estimate->uncertainty);
    EXPECT_LT(*estimate->doubt, 1.05);
    EXPECT_TRUE(estimate->isTrusted());
}

// Of small films and large ones, the bound is too low no more often than it says: once in 3060.
TEST(ErrorEstimateTest, BoundHoldsButForOneIn3060) {
    constexpr int kFilms = 4000;
    for (const size_t pixels : {size_t{1}, size_t{4}, size_t{30}}) {
        const double truth = 1.96 * 0.05 / std::sqrt(8.0);
        int tooLow = 0;
        double mean = 0.0;
        for (int i = 0; i < kFilms; ++i) {
            const auto estimate = estimateError(noisyFilm(pixels, 0.05, 100u + i));
            tooLow += estimate->upperBound() < truth ? 1 : 0;
            mean += estimate->upperBound() / kFilms;
        }
        EXPECT_LE(tooLow, 7) << pixels; // 1.3 expected; 8 once in 10,000 such tests
        EXPECT_LT(mean, pixels == 1 ? 5.0 * truth : 2.5 * truth) << pixels << ": and not idle";
    }
}

// One replica in eight of some pixels has all of its light: the rest of the picture looks alike.
TEST(ErrorEstimateTest, DoubtsItselfWhereRareSamplesBringTheLight) {
    std::vector<std::vector<double>> blocks(shared::kReplicas, std::vector<double>(400, 1.0));
    for (size_t pixel = 0; pixel < 20; ++pixel)
        blocks[pixel % shared::kReplicas][20 * pixel] = 1000.0;
    const auto estimate = estimateError(greyFilm(blocks));
    ASSERT_TRUE(estimate);
    EXPECT_GT(*estimate->doubt, 100.0);
    EXPECT_FALSE(estimate->isTrusted());
}

TEST(ErrorEstimateTest, TakesBlackAndEvenPictures) {
    std::vector<std::vector<double>> blocks(shared::kReplicas, std::vector<double>(3, 0.0));
    EXPECT_FALSE(estimateError(greyFilm(blocks))) << "a black picture may lack all of its light";
    // What float sums round is no noise.
    for (uint32_t block = 0; block < blocks.size(); ++block)
        blocks[block].assign(3, block == 5 ? std::nextafter(1.0f, 2.0f) : 1.0f);
    const auto even = estimateError(greyFilm(blocks));
    EXPECT_EQ(even->relative, 0.0);
    EXPECT_TRUE(even->isTrusted());
}

TEST(LuminanceTest, IsRec709s) {
    EXPECT_NEAR(luminance({1.0, 1.0, 1.0}), 1.0, 1e-15);
    EXPECT_EQ(luminance({1.0, 0.0, 0.0}), 0.2126);
    EXPECT_EQ(luminance({0.0, 0.0, 1.0}), 0.0722);
}

} // namespace
} // namespace calotype::test
