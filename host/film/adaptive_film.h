#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "film/film.h"
#include "image/image.h"
#include "shared/limits.h"

namespace calotype {

/// What one half of a film had found of a pixel's luminance when all pixels had as many samples.
struct SurveyPixel {
    float mean = 0.0f;     ///< in units
    float variance = 0.0f; ///< of the mean, estimated from the half's four replicas
};

/// The samples of a picture so far, where some pixels have more of them than others.
///
/// Its blocks and replicas are those of a Film. Those of even numbers make one half, those of odd
/// numbers the other; of each half every pixel has the first few blocks. The picture is the mean of
/// both halves' pictures. It is free of bias if the number of a half's samples in a pixel is chosen
/// by what the other half found, from numbers of samples that nothing found has decided on: the
/// *surveys*, which are kept of the moments when a pixel has 4, 8, 16, ... blocks of a half.
class AdaptiveFilm {
public:
    static constexpr uint32_t kHalves = 2;
    static constexpr uint32_t kReplicasPerHalf = shared::kReplicas / kHalves;

    /// Black, of width * height > 0 pixels; `unit` is a power of two, as filmUnit gives it.
    AdaptiveFilm(uint32_t width, uint32_t height, double unit);

    /// Adds a block to the pixels whose next block of its half it is, all that are not left out: a
    /// byte for each pixel, 0 or 1. Sums and losses are as for Film::addBlock.
    void addBlock(uint32_t block, std::span<const glm::vec4> blockSums,
                  std::span<const uint8_t> isLeftOut, const FilmLosses& losses = {});

    /// Radiance per pixel. `partialBlock`, if not empty, is like a block of `half`, but with any
    /// number of samples in each pixel that is not left out: it shows in the picture only.
    Image picture(uint32_t half = 0, std::span<const glm::vec4> partialBlock = {},
                  std::span<const uint8_t> isLeftOut = {}) const;

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    size_t pixelCount() const { return halves_[0].blocks.size(); }
    const FilmLosses& losses() const { return losses_; }

    /// Of all pixels together.
    uint64_t samples() const { return samples_; }

    /// Number of blocks that the pixels have of a half.
    std::span<const uint32_t> blocksOf(uint32_t half) const { return halves_[half].blocks; }

    /// What a half had found of each pixel when it had 4 * 2^level blocks of it; all pixels have
    /// to have them.
    std::span<const SurveyPixel> survey(uint32_t half, uint32_t level) const;

    /// Gives back the memory of the surveys below a level.
    void forgetSurveysBelow(uint32_t level);

    /// Of a pixel's samples, those of one replica; and the sum of their luminance, W/(m^2 sr).
    uint64_t samplesOfReplica(uint32_t replica, size_t pixel) const;
    double replicaLuminance(uint32_t replica, size_t pixel) const {
        return unit_ * fromFixedPoint(luminances_[replica * pixelCount() + pixel]);
    }

private:
    struct Half {
        std::vector<Film::Sum> colors;
        std::vector<uint32_t> blocks;
        std::vector<std::vector<SurveyPixel>> surveys; ///< by level; empty ones are not begun
    };

    void recordSurvey(uint32_t half, size_t pixel);

    uint32_t width_;
    uint32_t height_;
    double unit_;
    std::array<Half, kHalves> halves_;
    std::vector<FixedPoint> luminances_; ///< those of all pixels for replica 0, 1, ...
    uint64_t samples_ = 0;
    uint32_t firstSurvey_ = 0; ///< that is kept
    FilmLosses losses_;
};

} // namespace calotype
