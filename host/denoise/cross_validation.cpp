#include "denoise/cross_validation.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/exponential.hpp>

#include "base/check.h"
#include "film/error_estimate.h"
#include "film/looks.h"
#include "math/luminance.h"
#include "math/square.h"

namespace calotype {
namespace {

/// A number for each pixel, row by row.
using Plane = std::vector<double>;

/// The pixels around one whose errors decide how it is blended: 9 x 9.
constexpr uint32_t kBoxRadius = 4;
/// A denoiser spreads an error over its neighbours; the errors of tiles of this size, in pixels,
/// count as independent of each other.
constexpr uint32_t kTile = 16;
constexpr double kNormalQuantile95 = 1.645; ///< one-sided
constexpr size_t kLeastTiles = 8;           ///< for a bound

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

/// The replicas, and what one or all of them give without the denoiser.
class Replicas {
public:
    explicit Replicas(std::span<const ReplicaPicture> replicas) : replicas_(replicas) {
        CALOTYPE_CHECK_LE(kLeastReplicas, replicas.size());
        for (const ReplicaPicture& replica : replicas) {
            CALOTYPE_CHECK_LT(0.0, replica.samples);
            CALOTYPE_CHECK_EQ(replica.mean.width, width());
            CALOTYPE_CHECK_EQ(replica.mean.height, height());
            samples_ += replica.samples;
        }
    }

    size_t count() const { return replicas_.size(); }
    uint32_t width() const { return replicas_.front().mean.width; }
    uint32_t height() const { return replicas_.front().mean.height; }
    const ReplicaPicture& operator[](size_t i) const { return replicas_[i]; }
    double samples() const { return samples_; }

    /// The mean of all replicas but one; of all, if `left` is count().
    glm::dvec3 meanWithout(size_t left, size_t pixel) const {
        glm::dvec3 sum(0.0);
        for (size_t i = 0; i < count(); ++i)
            if (i != left)
                sum += replicas_[i].samples * glm::dvec3(replicas_[i].mean.pixels[pixel]);
        return sum / samplesWithout(left);
    }

    Image meanWithout(size_t left) const {
        Image image(width(), height());
        for (size_t pixel = 0; pixel < image.pixels.size(); ++pixel)
            image.pixels[pixel] = glm::vec3(meanWithout(left, pixel));
        return image;
    }

    /// Likewise, with the noise of that mean. The replica that is left out has no part in either.
    NoisyImage pictureWithout(size_t left) const {
        NoisyImage picture{meanWithout(left), Image(width(), height()), countWithout(left)};
        const double divisor = static_cast<double>(countWithout(left) - 1) * samplesWithout(left);
        for (size_t pixel = 0; pixel < picture.color.pixels.size(); ++pixel) {
            const glm::dvec3 mean = meanWithout(left, pixel);
            glm::dvec3 squares(0.0);
            for (size_t i = 0; i < count(); ++i)
                if (i != left) {
                    const glm::dvec3 deviation = glm::dvec3(replicas_[i].mean.pixels[pixel]) - mean;
                    squares += replicas_[i].samples * deviation * deviation;
                }
            picture.standardError.pixels[pixel] = glm::vec3(glm::sqrt(squares / divisor));
        }
        return picture;
    }

    size_t countWithout(size_t left) const { return count() - (left < count() ? 1 : 0); }

    double samplesWithout(size_t left) const {
        return samples_ - (left < count() ? replicas_[left].samples : 0.0);
    }

    /// The variance of the luminance of one sample, from the spread of all replicas but one.
    double varianceWithout(size_t left, size_t pixel) const {
        double sum = 0.0;
        double squares = 0.0;
        for (size_t i = 0; i < count(); ++i)
            if (i != left) {
                const double value = luminanceOf(replicas_[i].mean.pixels[pixel]);
                sum += replicas_[i].samples * value;
                squares += replicas_[i].samples * square(value);
            }
        const double spread = squares - square(sum) / samplesWithout(left);
        return std::max(spread, 0.0) / static_cast<double>(countWithout(left) - 1);
    }

private:
    std::span<const ReplicaPicture> replicas_;
    double samples_ = 0.0;
};

/// One denoised picture and its error. Of the pictures that were denoised without a replica, only
/// the luminance is kept, and numbers that the replicas give again are not: the picture may be
/// large.
class CrossValidation {
public:
    CrossValidation(std::span<const ReplicaPicture> replicas, Denoiser& denoiser,
                    const std::function<void(double)>& onProgress)
        : replicas_(replicas), denoiser_(denoiser), onProgress_(onProgress),
          pixels_(replicas.front().mean.pixels.size()), errorSums_(pixels_) {
        for (size_t i = 0; i < replicas_.count(); ++i) {
            denoised_.push_back(luminancesOf(denoisedWithout(i)));
            for (size_t pixel = 0; pixel < pixels_; ++pixel)
                errorSums_[pixel] += squaredError(denoised_[i][pixel], i, pixel);
        }
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
    /// The denoised mean of all replicas but one; of all, if `left` is their number. It is the
    /// last.
    Image denoisedWithout(size_t left) const {
        Image image = denoiser_.run(replicas_.pictureWithout(left));
        if (onProgress_)
            onProgress_(static_cast<double>(left + 1) / static_cast<double>(replicas_.count() + 1));
        return image;
    }

    /// An unbiased estimate of the squared error of a luminance by a replica that had no part in
    /// it: the squared distance from that replica, less its own variance.
    double squaredError(double value, size_t judge, size_t pixel) const {
        const ReplicaPicture& replica = replicas_[judge];
        return square(value - luminanceOf(replica.mean.pixels[pixel])) -
               replicas_.varianceWithout(judge, pixel) / replica.samples;
    }

    /// The weights of the samples in the blend of the denoised mean of all replicas but one with
    /// that mean. The one that is left out will judge the blend, so it must not choose the weights.
    Plane weightsOfSamples(size_t left) const {
        const bool isJudged = left < replicas_.count();
        Plane errors = errorSums_;
        Plane variances(pixels_);
        for (size_t i = 0; i < pixels_; ++i) {
            errors[i] -= isJudged ? squaredError(denoised_[left][i], left, i) : 0.0;
            errors[i] /= static_cast<double>(replicas_.countWithout(left));
            variances[i] = replicas_.varianceWithout(left, i) / replicas_.samplesWithout(left);
        }
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
        Plane shares(pixels_);
        for (size_t judge = 0; judge < replicas_.count(); ++judge) {
            const Plane weights = weightsOfSamples(judge);
            for (size_t i = 0; i < pixels_; ++i) {
                const double denoised = denoised_[judge][i];
                const double samples = luminance(replicas_.meanWithout(judge, i));
                const double blended = denoised + weights[i] * (samples - denoised);
                shares[i] += squaredError(blended, judge, i) /
                             (square(luminanceOf(color.pixels[i])) + floor) /
                             static_cast<double>(replicas_.count());
            }
        }
        const TileMean share = meanOfTiles(shares, color.width, color.height);
        const auto above = [&](double quantile) {
            return relativeError(std::max(share.mean + quantile * share.standardError, 0.0));
        };
        return DenoisedError{above(0.0), above(kNormalQuantile95), above(kSharedQuantile)};
    }

    Replicas replicas_;
    Denoiser& denoiser_;
    const std::function<void(double)>& onProgress_;
    size_t pixels_;
    std::vector<Plane> denoised_; ///< luminances of the mean of the others, denoised, per replica
    Plane errorSums_;             ///< sums of the squaredErrors of `denoised_`
};

} // namespace

bool canStateError(uint32_t width, uint32_t height) {
    const auto tilesAlong = [](uint32_t side) { return (size_t{side} + kTile - 1) / kTile; };
    return tilesAlong(width) * tilesAlong(height) >= kLeastTiles;
}

DenoisedPicture denoise(std::span<const ReplicaPicture> replicas, Denoiser& denoiser,
                        const std::function<void(double)>& onProgress) {
    return CrossValidation(replicas, denoiser, onProgress).run();
}

} // namespace calotype
