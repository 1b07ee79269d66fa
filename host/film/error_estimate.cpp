#include "film/error_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace calotype {
namespace {

using gpu::kReplicas;

/// Standard errors within which 95 % of normally distributed errors lie.
constexpr double kNormalInterval = 1.96;

/// Likewise of Student's t for 1, 2, ... degrees of freedom.
constexpr std::array<double, kReplicas - 1> kStudentInterval = {12.706, 4.303, 3.182, 2.776,
                                                                2.571,  2.447, 2.365};

/// The one-sided normal quantile of 1 - 0.05 / 20: a level of 5 % shared by the 20 doublings from
/// 128 samples to the most there can be.
constexpr double kSharedQuantile = 2.807;

/// From 512 samples on, the doubt is below 1.13 in the project's scenes, whose estimates are right
/// to a tenth, and mostly above 9 where glass balls gather the light of a small lamp.
constexpr double kMostDoubt = 1.4;

/// A spread below this share of the luminance is the rounding of float sums, not noise.
constexpr double kRounding = 1e-6;

/// What the replicas say of a pixel's luminance.
struct PixelSpread {
    double mean = 0.0;
    double variance = 0.0; ///< of the mean
    /// The variance over L^2 + floor^2, where L is the mean of all replicas; and where it is, for
    /// each replica's deviation, the mean of the others.
    double relative = 0.0;
    double relativeToOthers = 0.0;
};

/// The replicas that hold samples, at least two for spreads. Those of n samples have a variance of
/// s^2 / n, so deviations are weighted by n.
class Replicas {
public:
    explicit Replicas(const Film& film)
        : film_(film), all_(static_cast<double>(film.samplesPerPixel())) {
        for (uint32_t replica = 0; replica < kReplicas; ++replica)
            if (const uint64_t samples = film.samplesOfReplica(replica)) {
                indices_[count_] = replica;
                samples_[count_++] = static_cast<double>(samples);
            }
    }

    uint32_t count() const { return count_; }

    double meanOf(size_t pixel) const {
        double sum = 0.0;
        for (uint32_t i = 0; i < count_; ++i)
            sum += sumOf(i, pixel);
        return sum / all_;
    }

    PixelSpread spreadOf(size_t pixel, double floor) const {
        PixelSpread spread;
        spread.mean = meanOf(pixel);
        const auto square = [](double x) { return x * x; };
        const auto share = [&](double part, double luminance) {
            return part > 0.0 ? part / (square(luminance) + square(floor)) : 0.0;
        };
        for (uint32_t i = 0; i < count_; ++i) {
            const double sum = sumOf(i, pixel);
            const double others = (spread.mean * all_ - sum) / (all_ - samples_[i]);
            const double part = samples_[i] * square(sum / samples_[i] - spread.mean);
            spread.variance += part;
            spread.relativeToOthers += share(part, others);
        }
        const double scale = 1.0 / ((count_ - 1) * all_);
        spread.variance *= scale;
        if (spread.variance <= square(kRounding * spread.mean))
            return {spread.mean, spread.variance, 0.0, 0.0};
        spread.relative = share(spread.variance, spread.mean);
        spread.relativeToOthers *= scale;
        return spread;
    }

private:
    double sumOf(uint32_t i, size_t pixel) const {
        return film_.replicaLuminance(indices_[i], pixel);
    }

    const Film& film_;
    double all_;
    uint32_t count_ = 0;
    std::array<uint32_t, kReplicas> indices_{};
    std::array<double, kReplicas> samples_{};
};

} // namespace

bool ErrorEstimate::isTrusted() const { return doubt.has_value() && *doubt <= kMostDoubt; }

/// A chi-square variable of n = 2 / uncertainty^2 degrees of freedom, over n, is at least the cube
/// of 1 - a - z sqrt(a), with a = 2 / (9 n) (Wilson and Hilferty 1931).
double ErrorEstimate::upperBound() const {
    const double a = uncertainty * uncertainty / 9.0;
    const double root = std::max(0.0, 1.0 - a - kSharedQuantile * std::sqrt(a));
    return relative == 0.0 ? 0.0 : relative / std::sqrt(root * root * root);
}

std::optional<ErrorEstimate> estimateError(const Film& film) {
    const Replicas replicas(film);
    if (replicas.count() < 2)
        return std::nullopt;
    const auto pixels = static_cast<double>(film.pixelCount());
    double luminances = 0.0;
    for (size_t i = 0; i < film.pixelCount(); ++i)
        luminances += replicas.meanOf(i);
    if (luminances <= 0.0)
        return std::nullopt;
    const double floor = 0.01 * luminances / pixels;
    double sum = 0.0;
    double squares = 0.0;
    double toOthers = 0.0;
    for (size_t i = 0; i < film.pixelCount(); ++i) {
        const PixelSpread spread = replicas.spreadOf(i, floor);
        sum += spread.relative;
        squares += spread.relative * spread.relative;
        toOthers += spread.relativeToOthers;
    }
    ErrorEstimate estimate;
    estimate.relative = kNormalInterval * std::sqrt(sum / pixels);
    estimate.replicas = replicas.count();
    // A sum of estimates of n degrees of freedom each has about n sum^2 / squares of them
    // (Satterthwaite 1946), and a share of 2 over that as its variance.
    if (sum > 0.0)
        estimate.uncertainty = std::sqrt(2.0 * squares / (replicas.count() - 1)) / sum;
    if (replicas.count() == kReplicas)
        estimate.doubt = sum > 0.0 ? std::sqrt(toOthers / sum) : 1.0;
    return estimate;
}

std::vector<PixelError> pixelErrors(const Film& film) {
    const Replicas replicas(film);
    constexpr float kUnknown = std::numeric_limits<float>::infinity();
    std::vector<PixelError> errors(film.pixelCount(), {kUnknown, kUnknown});
    if (replicas.count() < 2)
        return errors;
    const double interval = kStudentInterval[replicas.count() - 2];
    for (size_t i = 0; i < errors.size(); ++i) {
        const double standardError = std::sqrt(replicas.spreadOf(i, 0.0).variance);
        errors[i] = {static_cast<float>(standardError),
                     static_cast<float>(interval * standardError)};
    }
    return errors;
}

} // namespace calotype
