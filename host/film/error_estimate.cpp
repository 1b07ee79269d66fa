#include "film/error_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "film/adaptive_film.h"
#include "film/film.h"
#include "film/looks.h"
#include "math/square.h"

namespace calotype {
namespace {

using shared::kReplicas;

/// Standard errors within which 95 % of normally distributed errors lie.
constexpr double kNormalInterval = 1.96;

/// Likewise of Student's t for 1, 2, ... degrees of freedom.
constexpr std::array<double, kReplicas - 1> kStudentInterval = {12.706, 4.303, 3.182, 2.776,
                                                                2.571,  2.447, 2.365};

/// The same for any number of them in [1, 7]: linear between whole ones.
double studentInterval(double degrees) {
    const size_t below =
        std::clamp<size_t>(static_cast<size_t>(degrees), 1, kStudentInterval.size() - 1);
    return std::lerp(kStudentInterval[below - 1], kStudentInterval[below],
                     degrees - static_cast<double>(below));
}

/// From 512 samples on, the doubt is below 1.13 in the project's scenes, where the estimates are
/// correct to 10 %, and mostly above 9 where glass balls focus the light of a small lamp.
constexpr double kMostDoubt = 1.4;

/// A spread below this share of the luminance is the rounding of float sums, not noise.
constexpr double kRounding = 1e-6;

/// Statistics of a pixel's luminance over its replicas.
struct PixelSpread {
    double mean = 0.0;
    double variance = 0.0; ///< of the mean
    double degrees = 0.0;  ///< of freedom, of the variance
    /// relativeShare of the variance, where L is the mean of all replicas; and where L is, for the
    /// deviation of each replica, the mean of the others.
    double relative = 0.0;
    double relativeToOthers = 0.0;
};

/// Samples of one replica in a pixel, and the sum of their luminance.
struct ReplicaSum {
    double samples = 0.0;
    double luminance = 0.0;
};

/// Those replicas of one pixel that have samples.
class Replicas {
public:
    void add(const ReplicaSum& replica) {
        replicas_[count_++] = replica;
        all_.samples += replica.samples;
        all_.luminance += replica.luminance;
    }

    uint32_t count() const { return count_; }
    const ReplicaSum& all() const { return all_; }
    double mean() const { return all_.luminance / all_.samples; }

    /// Variance of the mean of at least two replicas. A replica of n samples has a variance of
    /// s^2 / n, so deviations are weighted by n. The result is a sum of one part for each replica;
    /// `share(part, replica)` is called for each.
    template <typename Share>
    double variance(const Share& share) const {
        const double scale = 1.0 / ((count_ - 1) * all_.samples);
        double sum = 0.0;
        for (uint32_t i = 0; i < count_; ++i) {
            const auto& [samples, luminance] = replicas_[i];
            const double part = scale * samples * square(luminance / samples - mean());
            sum += part;
            share(part, replicas_[i]);
        }
        return sum;
    }

private:
    std::array<ReplicaSum, kReplicas> replicas_{};
    uint32_t count_ = 0;
    ReplicaSum all_;
};

/// Sets the relative variance; 0 where the spread is only the rounding of float sums.
PixelSpread withoutRounding(PixelSpread spread, double meanLuminance) {
    if (spread.variance <= square(kRounding * spread.mean))
        return {spread.mean, spread.variance, spread.degrees, 0.0, 0.0};
    spread.relative = relativeShare(spread.variance, spread.mean, meanLuminance);
    return spread;
}

/// The pixels of a Film: all have samples in the same replicas.
class EvenPixels {
public:
    explicit EvenPixels(const Film& film) : film_(film) {
        for (uint32_t replica = 0; replica < kReplicas; ++replica) {
            samples_[replica] = static_cast<double>(film.samplesOfReplica(replica));
            replicas_ += samples_[replica] > 0.0 ? 1 : 0;
        }
    }

    size_t count() const { return film_.pixelCount(); }
    uint32_t replicas() const { return replicas_; }
    bool areEnough() const { return replicas_ >= 2; }
    double meanOf(size_t pixel) const { return replicasOf(pixel).mean(); }

    PixelSpread spreadOf(size_t pixel, double meanLuminance) const {
        const Replicas replicas = replicasOf(pixel);
        const ReplicaSum& all = replicas.all();
        PixelSpread spread{replicas.mean(), 0.0, static_cast<double>(replicas.count() - 1), 0, 0};
        spread.variance = replicas.variance([&](double part, const ReplicaSum& one) {
            const double others = (all.luminance - one.luminance) / (all.samples - one.samples);
            spread.relativeToOthers += relativeShare(part, others, meanLuminance);
        });
        return withoutRounding(spread, meanLuminance);
    }

private:
    Replicas replicasOf(size_t pixel) const {
        Replicas replicas;
        for (uint32_t replica = 0; replica < kReplicas; ++replica)
            if (samples_[replica] > 0.0)
                replicas.add({samples_[replica], film_.replicaLuminance(replica, pixel)});
        return replicas;
    }

    const Film& film_;
    std::array<double, kReplicas> samples_{};
    uint32_t replicas_ = 0;
};

/// The pixels of an AdaptiveFilm: the mean of two halves, each with replicas of its own.
class HalvedPixels {
public:
    explicit HalvedPixels(const AdaptiveFilm& film) : film_(film) {
        uint32_t least = film.blocksOf(0)[0];
        for (uint32_t half = 0; half < AdaptiveFilm::kHalves; ++half)
            least = std::min(least, *std::ranges::min_element(film.blocksOf(half)));
        replicas_ = AdaptiveFilm::kHalves * std::min(least, AdaptiveFilm::kReplicasPerHalf);
    }

    size_t count() const { return film_.pixelCount(); }
    uint32_t replicas() const { return replicas_; }
    bool areEnough() const { return replicas_ >= 2 * AdaptiveFilm::kHalves; }

    double meanOf(size_t pixel) const {
        return 0.5 * (half(0, pixel).mean() + half(1, pixel).mean());
    }

    PixelSpread spreadOf(size_t pixel, double meanLuminance) const {
        const std::array<Replicas, AdaptiveFilm::kHalves> halves = {half(0, pixel), half(1, pixel)};
        const double all = halves[0].all().samples + halves[1].all().samples;
        const double sum = halves[0].all().luminance + halves[1].all().luminance;
        PixelSpread spread{0.5 * (halves[0].mean() + halves[1].mean()), 0.0, 0.0, 0.0, 0.0};
        double squares = 0.0; // of the halves' variances, over their degrees of freedom
        for (const Replicas& half : halves) {
            const double variance = half.variance([&](double part, const ReplicaSum& one) {
                const double others = (sum - one.luminance) / (all - one.samples);
                spread.relativeToOthers += relativeShare(0.25 * part, others, meanLuminance);
            });
            spread.variance += 0.25 * variance;
            squares += square(0.25 * variance) / (half.count() - 1);
        }
        spread.degrees = squares > 0.0 ? square(spread.variance) / squares : 1.0; // Welch 1947
        return withoutRounding(spread, meanLuminance);
    }

private:
    Replicas half(uint32_t half, size_t pixel) const {
        Replicas replicas;
        for (uint32_t i = half; i < kReplicas; i += AdaptiveFilm::kHalves)
            if (const uint64_t samples = film_.samplesOfReplica(i, pixel))
                replicas.add({static_cast<double>(samples), film_.replicaLuminance(i, pixel)});
        return replicas;
    }

    const AdaptiveFilm& film_;
    uint32_t replicas_ = 0;
};

template <typename Pixels>
std::optional<ErrorEstimate> estimate(const Pixels& pixels) {
    if (!pixels.areEnough())
        return std::nullopt;
    const auto count = static_cast<double>(pixels.count());
    double luminances = 0.0;
    for (size_t i = 0; i < pixels.count(); ++i)
        luminances += pixels.meanOf(i);
    if (luminances <= 0.0)
        return std::nullopt;
    const double meanLuminance = luminances / count;
    double sum = 0.0;
    double squares = 0.0;
    double toOthers = 0.0;
    for (size_t i = 0; i < pixels.count(); ++i) {
        const PixelSpread spread = pixels.spreadOf(i, meanLuminance);
        sum += spread.relative;
        squares += square(spread.relative) / spread.degrees;
        toOthers += spread.relativeToOthers;
    }
    ErrorEstimate estimate;
    estimate.relative = relativeError(sum / count);
    estimate.replicas = pixels.replicas();
    // A sum of estimates of n degrees of freedom each has sum^2 / (squares / n) of them
    // (Satterthwaite 1946), and a share of 2 over that as its variance.
    if (sum > 0.0)
        estimate.uncertainty = std::sqrt(2.0 * squares) / sum;
    if (pixels.replicas() == kReplicas)
        estimate.doubt = sum > 0.0 ? std::sqrt(toOthers / sum) : 1.0;
    return estimate;
}

template <typename Pixels>
std::vector<PixelError> errorsOf(const Pixels& pixels) {
    constexpr float kUnknown = std::numeric_limits<float>::infinity();
    std::vector<PixelError> errors(pixels.count(), {kUnknown, kUnknown});
    if (!pixels.areEnough())
        return errors;
    for (size_t i = 0; i < errors.size(); ++i) {
        const PixelSpread spread = pixels.spreadOf(i, 0.0);
        const double standardError = std::sqrt(spread.variance);
        errors[i] = {static_cast<float>(standardError),
                     static_cast<float>(studentInterval(spread.degrees) * standardError)};
    }
    return errors;
}

} // namespace

double relativeShare(double variance, double luminance, double meanLuminance) {
    const double floor = 0.01 * meanLuminance;
    return variance > 0.0 ? variance / (square(luminance) + square(floor)) : 0.0;
}

double relativeError(double meanShare) { return kNormalInterval * std::sqrt(meanShare); }

Trust ErrorEstimate::trust() const {
    if (!doubt)
        return Trust::TooFewSamples;
    return *doubt <= kMostDoubt ? Trust::Trusted : Trust::RareLight;
}

/// A chi-square variable of n = 2 / uncertainty^2 degrees of freedom, over n, is at least the cube
/// of 1 - a - z sqrt(a), with a = 2 / (9 n) (Wilson and Hilferty 1931).
double ErrorEstimate::upperBound() const {
    const double a = uncertainty * uncertainty / 9.0;
    const double root = std::max(0.0, 1.0 - a - kSharedQuantile * std::sqrt(a));
    return relative == 0.0 ? 0.0 : relative / std::sqrt(root * root * root);
}

std::optional<ErrorEstimate> estimateError(const Film& film) { return estimate(EvenPixels(film)); }

std::optional<ErrorEstimate> estimateError(const AdaptiveFilm& film) {
    return estimate(HalvedPixels(film));
}

std::vector<PixelError> pixelErrors(const Film& film) { return errorsOf(EvenPixels(film)); }

std::vector<PixelError> pixelErrors(const AdaptiveFilm& film) {
    return errorsOf(HalvedPixels(film));
}

} // namespace calotype
