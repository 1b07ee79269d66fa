// When a render ends by the error after denoising: sequences of made-up errors.
#include "engine/denoised_goal.h"

#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "film/looks.h"
#include "math/square.h"
#include "render/error_watch.h"
#include "settings/limits.h"

namespace calotype::test {
namespace {

/// A black pixel of so many samples, a multiple of 16.
Film filmOf(uint64_t samples) {
    Film::Sums sums = Film(1, 1, 1.0).sums();
    sums.blocks.add({0, static_cast<uint32_t>(samples / shared::kSamplesPerBlock)});
    return {1, 1, 1.0, std::move(sums)};
}

/// The error that is stated of a picture of so many samples; nothing if none is.
using Stated = std::function<std::optional<DenoisedError>(uint64_t samples)>;

/// A render whose denoiser finds made-up errors. A look takes one second, denoising `cost`.
class MadeUpRender {
public:
    MadeUpRender(double target, Stated stated, double cost = 0.0)
        : stated_(std::move(stated)), cost_(cost),
          goal_(
              target, [this](const FilmView& film) { return denoised(film); },
              [this] { return seconds_; }) {
        renderGoal_.targetError = target;
        renderGoal_.denoisedError = [this](const FilmView& film) { return goal_.errorOf(film); };
    }

    /// The samples at which it ends by its goal, as sessions do; none if it has all its samples.
    std::optional<uint64_t> run(uint64_t mostSamples = kMostSamplesPerPixel) {
        RenderTotals totals;
        for (uint64_t samples = kFirstLook; samples <= mostSamples; samples = lookAfter(samples)) {
            seconds_ += 1.0;
            const Film film = filmOf(samples);
            if (isReachedDenoised(renderGoal_, film, totals))
                return samples;
        }
        return std::nullopt;
    }

    DenoisedGoal& goal() { return goal_; }

    /// Samples of the pictures that were denoised.
    const std::vector<uint64_t>& denoised() const { return denoised_; }

private:
    CleanPicture denoised(const FilmView& film) {
        denoised_.push_back(film.samplesPerPixel());
        seconds_ += cost_;
        return {Image(1, 1), "made up", stated_(film.samplesPerPixel()), ""};
    }

    Stated stated_;
    double cost_;
    double seconds_ = 0.0;
    std::vector<uint64_t> denoised_;
    DenoisedGoal goal_;
    RenderGoal renderGoal_;
};

/// Bounds of `at128` after 128 samples that fall with the root of the samples.
Stated falling(double at128) {
    return [at128](uint64_t samples) {
        const double bound = at128 * std::sqrt(128.0 / static_cast<double>(samples));
        return DenoisedError{0.8 * bound, 0.9 * bound, bound};
    };
}

TEST(DenoisedGoalTest, EndsAtTheFirstLookWhoseBoundIsBelowTheTarget) {
    for (const double at128 : {0.01, 0.05, 0.0501, 0.1, 0.23, 0.9}) {
        MadeUpRender render(0.05, falling(at128));
        uint64_t first = kFirstLook;
        while (falling(at128)(first)->upperBound > 0.05)
            first = lookAfter(first);
        EXPECT_EQ(render.run(), first) << at128;
        EXPECT_EQ(render.denoised().back(), first);
        // The next picture has twice the samples, unless fewer are expected to be enough.
        EXPECT_LE(static_cast<double>(render.denoised().size()),
                  2.0 + std::log2(static_cast<double>(first) / 128.0));
    }
}

// The stated error and the printed bound do not end a render.
TEST(DenoisedGoalTest, GoesOnWhileTheSharedBoundIsAboveTheTarget) {
    MadeUpRender render(0.05, [](uint64_t) { return DenoisedError{0.01, 0.02, 0.0501}; });
    EXPECT_FALSE(render.run());
    EXPECT_GT(render.denoised().size(), 15u) << "at each doubling at least";
}

TEST(DenoisedGoalTest, GoesOnWhereNoErrorIsStated) {
    MadeUpRender render(0.05, [](uint64_t) { return std::optional<DenoisedError>(); });
    EXPECT_FALSE(render.run(4096));
    EXPECT_EQ(render.denoised().size(), 41u) << "every look: the error may be stated at the next";
}

// One bound that is far too large does not put off the next look beyond twice the samples.
TEST(DenoisedGoalTest, OneUncertainBoundPutsOffLittle) {
    MadeUpRender render(0.05, [](uint64_t samples) {
        return samples == 128 ? DenoisedError{0.04, 0.2, 9.0} : DenoisedError{0.01, 0.02, 0.03};
    });
    EXPECT_EQ(render.run(), 256u);
}

// As much time for rendering as for denoising. Looks are a second apart.
TEST(DenoisedGoalTest, DenoisesInHalfOfTheTimeAtMost) {
    MadeUpRender render(
        0.05,
        [](uint64_t) {
            return DenoisedError{0.04, 0.045, 0.0501};
        },
        3.0);
    EXPECT_FALSE(render.run(512));
    EXPECT_EQ(render.denoised(), (std::vector<uint64_t>{128, 176, 224, 288, 384, 480}));
    EXPECT_EQ(render.goal().seconds(), 18.0);
}

TEST(DenoisedGoalTest, AFailureEndsTheWork) {
    MadeUpRender render(
        0.05, [](uint64_t) -> std::optional<DenoisedError> { throw Error("it was told to"); });
    EXPECT_FALSE(render.run(512));
    EXPECT_EQ(render.denoised().size(), 1u);
    EXPECT_TRUE(render.goal().failure());
    MadeUpRender stopped(0.05,
                         [](uint64_t) -> std::optional<DenoisedError> { throw Interrupted(); });
    EXPECT_FALSE(stopped.run(144));
    EXPECT_FALSE(stopped.goal().failure()) << "a stop is no failure";
}

// It is the picture of the render only if no sample came after it.
TEST(DenoisedGoalTest, GivesThePictureOfTheSameSamplesOnce) {
    MadeUpRender render(0.05, falling(0.05));
    ASSERT_EQ(render.run(), 128u);
    EXPECT_FALSE(render.goal().take(filmOf(144)));
    const Film film = filmOf(128);
    EXPECT_TRUE(render.goal().take(film));
    EXPECT_FALSE(render.goal().take(film));
}

/// The error in the measure of ErrorEstimate::relative: 1.96 times the root.
constexpr double kTrueShare = 0.01;

/// Independent normal estimates of the share, at every look.
Stated noisy(double share, double standardError, std::mt19937& random) {
    return [=, &random](uint64_t) {
        std::normal_distribution<double> noise(share, standardError);
        return denoisedErrorOf(noise(random), standardError);
    };
}

// The error never falls, and is the target itself: the worst case of independent looks. A render
// that looks at all 153 numbers of samples ends wrongly in 1 - (1 - 1 / 3060)^153 = 4.9 % of cases.
TEST(DenoisedGoalTest, SharesFivePercentAmongAllLooks) {
    constexpr int kRenders = 20000;
    constexpr double kError = 0.2 * kTrueShare;
    std::mt19937 random(1);
    const Stated stated = noisy(kTrueShare, kError, random);
    const double target = relativeError(kTrueShare);
    double wrong = 0.0;
    for (int i = 0; i < kRenders; ++i) {
        bool hasEnded = false;
        for (int look = 0; look < kLooks; ++look)
            hasEnded = hasEnded || stated(0)->upperBound <= target;
        wrong += hasEnded ? 1.0 / kRenders : 0.0;
    }
    const double expected = 1.0 - std::pow(1.0 - 0.05 / kLooks, kLooks);
    EXPECT_NEAR(wrong, expected, 4.0 * std::sqrt(expected / kRenders));
    double wrongRenders = 0.0;
    for (int i = 0; i < 1000; ++i)
        wrongRenders += MadeUpRender(target, stated).run() ? 1e-3 : 0.0;
    EXPECT_GT(wrongRenders, 0.0);
    EXPECT_LT(wrongRenders, 0.05);
}

// It is not too careful: an error that is 12 % below the target ends the render at once in most
// cases, where the standard error of its square is 5 %.
TEST(DenoisedGoalTest, EndsWhereTheErrorIsClearlyBelowTheTarget) {
    std::mt19937 random(2);
    const Stated stated = noisy(kTrueShare, 0.05 * kTrueShare, random);
    const double target = relativeError(kTrueShare) / 0.88;
    double ended = 0.0;
    for (int i = 0; i < 1000; ++i)
        ended += MadeUpRender(target, stated).run(128) ? 1e-3 : 0.0;
    EXPECT_GT(ended, 0.95);
}

} // namespace
} // namespace calotype::test
