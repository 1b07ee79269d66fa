#include "denoise/cross_validation.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/exponential.hpp>

#include "base/check.h"
#include "base/parallel_chunks.h"
#include "film/error_estimate.h"
#include "math/luminance.h"
#include "math/square.h"

namespace calotype {
namespace {

/// A number for each pixel, row by row; or for each replica.
using Plane = std::vector<double>;

/// The pixels around one whose errors decide how it is blended: 9 x 9.
constexpr uint32_t kBoxRadius = 4;
/// A denoiser spreads an error over its neighbours; the errors of tiles of this size, in pixels,
/// count as independent of each other.
constexpr uint32_t kTile = 16;
constexpr size_t kLeastTiles = 8; ///< for a bound

double luminanceOf(const glm::vec3& color) { return luminance(glm::dvec3(color)); }

/// Means of the numbers at most kBoxRadius places away, `stride` apart, less at the ends. Each sum
/// is made anew: what a running sum loses to one huge number would stay in it.
void boxMeans(const double* in, double* out, uint32_t count, size_t stride) {
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t first = i - std::min(i, kBoxRadius);
        const uint32_t end = std::min(i + kBoxRadius + 1, count);
        double sum = 0.0;
        for (uint32_t k = first; k < end; ++k)
            sum += in[k * stride];
        out[i * stride] = sum / (end - first);
    }
}

Plane luminancesOf(const Image& image) {
    Plane luminances;
    luminances.reserve(image.pixels.size());
    for (const glm::vec3& pixel : image.pixels)
        luminances.push_back(luminanceOf(pixel));
    return luminances;
}

/// The mean over the box around each pixel, as far as it is in the picture.
Plane boxMean(const Plane& plane, uint32_t width, uint32_t height) {
    Plane rows(plane.size());
    for (uint32_t y = 0; y < height; ++y)
        boxMeans(&plane[size_t{y} * width], &rows[size_t{y} * width], width, 1);
    Plane means(plane.size());
    for (uint32_t x = 0; x < width; ++x)
        boxMeans(&rows[x], &means[x], height, width);
    return means;
}

/// The weight of the samples in a blend with a denoised picture, whose squared errors about a pixel
/// are `denoised`, while the variance of the samples is `variance`: of all weights the one with the
/// least squared error, where both errors are independent.
double weightOfSamples(double denoised, double variance) {
    const double error = std::max(denoised, 0.0);
    return variance > 0.0 ? error / (error + variance) : 1.0;
}

/// Mean and standard error of a number that every pixel has, from the means of tiles.
struct TileMean {
    double mean = 0.0;
    double standardError = 0.0;
    size_t tiles = 0;
};

TileMean meanOfTiles(const Plane& plane, uint32_t width, uint32_t height) {
    Plane sums;
    Plane sizes;
    for (uint32_t top = 0; top < height; top += kTile)
        for (uint32_t left = 0; left < width; left += kTile) {
            const uint32_t bottom = std::min(top + kTile, height);
            const uint32_t right = std::min(left + kTile, width);
            double sum = 0.0;
            for (uint32_t y = top; y < bottom; ++y)
                for (uint32_t x = left; x < right; ++x)
                    sum += plane[size_t{y} * width + x];
            sums.push_back(sum);
            sizes.push_back(static_cast<double>((bottom - top) * (right - left)));
        }
    TileMean result;
    for (const double sum : sums)
        result.mean += sum / static_cast<double>(plane.size());
    result.tiles = sums.size();
    // A ratio estimate: deviations of the tiles' sums from what their sizes let expect.
    const auto tiles = static_cast<double>(sums.size());
    double squares = 0.0;
    for (size_t i = 0; i < sums.size(); ++i)
        squares += square(sums[i] - result.mean * sizes[i]);
    if (tiles > 1.0)
        result.standardError =
            std::sqrt(squares * tiles / (tiles - 1.0)) / static_cast<double>(plane.size());
    return result;
}

/// The replicas, and what one or all of them give without the denoiser. `left` is the replica that
/// is left out, or count() for none.
class Replicas {
public:
    explicit Replicas(std::span<const ReplicaPicture> replicas) : replicas_(replicas) {
        for (const ReplicaPicture& replica : replicas) {
            CALOTYPE_CHECK_EQ(replica.mean.width, width());
            CALOTYPE_CHECK_EQ(replica.mean.height, height());
            CALOTYPE_CHECK_LT(0u, *std::ranges::min_element(replica.samples));
            groupSizes_.resize(std::max<size_t>(groupSizes_.size(), replica.group + 1));
            ++groupSizes_[replica.group];
        }
        CALOTYPE_CHECK_LE(kLeastReplicas, *std::ranges::min_element(groupSizes_));
    }

    size_t count() const { return replicas_.size(); }
    size_t countWithout(size_t left) const { return count() - (left < count() ? 1 : 0); }
    uint32_t width() const { return replicas_.front().mean.width; }
    uint32_t height() const { return replicas_.front().mean.height; }
    size_t pixels() const { return replicas_.front().mean.pixels.size(); }

    glm::dvec3 meanWithout(size_t left, size_t pixel) const {
        return colorWithout(left, pixel).mean;
    }

    /// The mean of all replicas but one, with its noise. The replica that is left out has no part
    /// in either.
    NoisyImage pictureWithout(size_t left, uint32_t threads) const {
        NoisyImage picture{Image(width(), height()), Image(width(), height()),
                           countWithout(left) - groupSizes_.size() + 1};
        parallelChunks(pixels(), threads, [&](size_t first, size_t end) {
            for (size_t pixel = first; pixel < end; ++pixel) {
                const Spread<glm::dvec3> spread = colorWithout(left, pixel);
                picture.color.pixels[pixel] = glm::vec3(spread.mean);
                picture.standardError.pixels[pixel] = glm::vec3(glm::sqrt(spread.variance));
            }
        });
        return picture;
    }

    /// Sets `luminances` to those that the replicas have in a pixel.
    void luminancesAt(size_t pixel, Plane& luminances) const {
        luminances.resize(count());
        for (size_t i = 0; i < count(); ++i)
            luminances[i] = luminanceOf(replicas_[i].mean.pixels[pixel]);
    }

    /// The luminance of the mean of all replicas but one.
    double meanWithout(const Plane& luminances, size_t left, size_t pixel) const {
        return spreadWithout<double>([&](size_t i) { return luminances[i]; }, pixel, left).mean;
    }

    /// The variance of the luminance of the mean of all replicas but one, from their spread.
    double varianceOfMeanWithout(const Plane& luminances, size_t left, size_t pixel) const {
        return spreadWithout<double>([&](size_t i) { return luminances[i]; }, pixel, left).variance;
    }

    /// That of one replica, from the spread of the others of its group. `left` is left out too,
    /// where enough others remain.
    double varianceOf(const Plane& luminances, size_t replica, size_t left, size_t pixel) const {
        const uint32_t group = replicas_[replica].group;
        const size_t both = groupSizes_[group] > kLeastReplicas ? left : replica;
        const auto valueOf = [&](size_t i) { return luminances[i]; };
        return groupWithout<double>(valueOf, group, pixel, replica, both).variance /
               replicas_[replica].samplesIn(pixel);
    }

private:
    /// Of some replicas in a pixel. Value: glm::dvec3 for colours, double for luminances.
    template <typename Value>
    struct Spread {
        Value mean = Value(0.0);
        Value variance = Value(0.0); ///< of the mean; of a group: of one sample
        double samples = 0.0;
    };

    Spread<glm::dvec3> colorWithout(size_t left, size_t pixel) const {
        const auto valueOf = [&](size_t i) { return glm::dvec3(replicas_[i].mean.pixels[pixel]); };
        return spreadWithout<glm::dvec3>(valueOf, pixel, left);
    }

    size_t countWithout(uint32_t group, size_t left) const {
        return groupSizes_[group] - (left < count() && replicas_[left].group == group ? 1 : 0);
    }

    /// Of the replicas of one group but one or two. A replica of n samples has a variance of s^2 /
    /// n, so deviations are weighted by n.
    template <typename Value, typename ValueOf>
    Spread<Value> groupWithout(const ValueOf& valueOf, uint32_t group, size_t pixel, size_t left,
                               size_t alsoLeft) const {
        Spread<Value> spread;
        const auto forEach = [&](const auto& take) {
            for (size_t i = 0; i < count(); ++i)
                if (i != left && i != alsoLeft && replicas_[i].group == group)
                    take(replicas_[i].samplesIn(pixel), valueOf(i));
        };
        double freedom = -1.0;
        forEach([&](double samples, const Value& mean) {
            spread.mean += samples * mean;
            spread.samples += samples;
            freedom += 1.0;
        });
        spread.mean /= spread.samples;
        forEach([&](double samples, const Value& mean) {
            const Value deviation = mean - spread.mean;
            spread.variance += samples * deviation * deviation;
        });
        spread.variance /= freedom;
        return spread;
    }

    /// Of the mean of all replicas but one.
    template <typename Value, typename ValueOf>
    Spread<Value> spreadWithout(const ValueOf& valueOf, size_t pixel, size_t left) const {
        Spread<Value> spread;
        for (uint32_t group = 0; group < groupSizes_.size(); ++group) {
            const auto ofGroup = groupWithout<Value>(valueOf, group, pixel, left, left);
            const double weight = static_cast<double>(countWithout(group, left)) /
                                  static_cast<double>(countWithout(left));
            spread.mean += weight * ofGroup.mean;
            spread.variance += square(weight) * ofGroup.variance / ofGroup.samples;
        }
        return spread;
    }

    std::span<const ReplicaPicture> replicas_;
    std::vector<size_t> groupSizes_;
};

/// One denoised picture and its error. Of the pictures that were denoised without a replica, only
/// the luminance is kept, and numbers that the replicas give again are not: the picture may be
/// large.
class CrossValidation {
public:
    CrossValidation(std::span<const ReplicaPicture> replicas, Denoiser& denoiser, uint32_t threads,
                    const std::function<void(double)>& onProgress)
        : replicas_(replicas), denoiser_(denoiser), threads_(threads > 0 ? threads : allCores()),
          onProgress_(onProgress), pixels_(replicas.front().mean.pixels.size()) {
        for (size_t i = 0; i < replicas_.count(); ++i)
            denoised_.push_back(luminancesOf(denoisedWithout(i)));
    }

    DenoisedPicture run() const {
        const size_t none = replicas_.count();
        Image color = denoisedWithout(none);
        const Plane weights = weightsOfSamples(none);
        for (size_t i = 0; i < pixels_; ++i) {
            const auto samples = glm::vec3(replicas_.meanWithout(none, i));
            color.pixels[i] += static_cast<float>(weights[i]) * (samples - color.pixels[i]);
        }
        const std::optional<DenoisedError> error = errorOf(color);
        return {std::move(color), error};
    }

private:
    /// The denoiser's runs, without each replica and with all, and a step in which the error is
    /// found.
    void report(double stepsDone) const {
        if (onProgress_)
            onProgress_(stepsDone / static_cast<double>(replicas_.count() + 2));
    }

    /// The denoised mean of all replicas but one; of all, if `left` is their number. It is the
    /// last.
    Image denoisedWithout(size_t left) const {
        Image image = denoiser_.run(replicas_.pictureWithout(left, threads_));
        report(static_cast<double>(left + 1));
        return image;
    }

    /// An unbiased estimate of the squared error of a luminance by a replica that had no part in
    /// it: the squared distance from that replica, less its own variance. Nothing is taken from
    /// `left`, but for the luminance.
    double squaredError(double value, const Plane& luminances, size_t judge, size_t left,
                        size_t pixel) const {
        return square(value - luminances[judge]) -
               replicas_.varianceOf(luminances, judge, left, pixel);
    }

    /// The weights of the samples in the blend of the denoised mean of all replicas but one with
    /// that mean. The one that is left out will judge the blend, so it must not choose the weights.
    Plane weightsOfSamples(size_t left) const {
        const auto judges = static_cast<double>(replicas_.countWithout(left));
        Plane errors(pixels_);
        Plane variances(pixels_);
        parallelChunks(pixels_, threads_, [&](size_t first, size_t end) {
            Plane luminances;
            for (size_t i = first; i < end; ++i) {
                replicas_.luminancesAt(i, luminances);
                for (size_t judge = 0; judge < replicas_.count(); ++judge)
                    if (judge != left)
                        errors[i] +=
                            squaredError(denoised_[judge][i], luminances, judge, left, i) / judges;
                variances[i] = replicas_.varianceOfMeanWithout(luminances, left, i);
            }
        });
        errors = boxMean(errors, replicas_.width(), replicas_.height());
        variances = boxMean(variances, replicas_.width(), replicas_.height());
        for (size_t i = 0; i < pixels_; ++i)
            errors[i] = weightOfSamples(errors[i], variances[i]);
        return errors;
    }

    /// The error of the picture: that of the same steps without each replica, as it judges them.
    std::optional<DenoisedError> errorOf(const Image& color) const {
        if (!canStateError(color.width, color.height))
            return std::nullopt;
        double meanLuminance = 0.0;
        for (const glm::vec3& pixel : color.pixels)
            meanLuminance += luminanceOf(pixel) / static_cast<double>(pixels_);
        const double floor = square(0.01 * meanLuminance);
        const auto judges = static_cast<double>(replicas_.count());
        Plane shares(pixels_);
        for (size_t judge = 0; judge < replicas_.count(); ++judge) {
            const Plane weights = weightsOfSamples(judge);
            parallelChunks(pixels_, threads_, [&](size_t first, size_t end) {
                Plane luminances;
                for (size_t i = first; i < end; ++i) {
                    replicas_.luminancesAt(i, luminances);
                    const double denoised = denoised_[judge][i];
                    const double samples = replicas_.meanWithout(luminances, judge, i);
                    const double blended = denoised + weights[i] * (samples - denoised);
                    shares[i] += squaredError(blended, luminances, judge, judge, i) /
                                 (square(luminanceOf(color.pixels[i])) + floor) / judges;
                }
            });
            report(judges + 1.0 + static_cast<double>(judge + 1) / judges);
        }
        const TileMean share = meanOfTiles(shares, color.width, color.height);
        return denoisedErrorOf(share.mean, share.standardError);
    }

    Replicas replicas_;
    Denoiser& denoiser_;
    uint32_t threads_;
    const std::function<void(double)>& onProgress_;
    size_t pixels_;
    std::vector<Plane> denoised_; ///< luminances of the mean of the others, denoised, per replica
};

} // namespace

bool canStateError(uint32_t width, uint32_t height) {
    const auto tilesAlong = [](uint32_t side) { return (size_t{side} + kTile - 1) / kTile; };
    return tilesAlong(width) * tilesAlong(height) >= kLeastTiles;
}

DenoisedPicture denoise(std::span<const ReplicaPicture> replicas, Denoiser& denoiser,
                        uint32_t threads, const std::function<void(double)>& onProgress) {
    return CrossValidation(replicas, denoiser, threads, onProgress).run();
}

} // namespace calotype
