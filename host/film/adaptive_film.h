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

/// One half's estimate of a pixel's luminance, from a number of samples that all pixels reach.
struct SurveyPixel {
    float mean = 0.0f;     ///< in units
    float variance = 0.0f; ///< of the mean, estimated from the half's four replicas
};

/// The samples of a picture so far, where some pixels have more of them than others.
///
/// Blocks and replicas are those of a Film. Blocks of even numbers belong to one half, those of odd
/// numbers to the other. A pixel has the first n blocks of each half; n differs between pixels and
/// halves. The picture is the mean of both halves' pictures. It has no bias if n in one half is
/// chosen from estimates of the other half after a fixed number of samples. These estimates are the
/// *surveys*: they are kept when a pixel has 4, 8, 16, ... blocks of a half.
class AdaptiveFilm {
public:
    static constexpr uint32_t kHalves = 2;
    static constexpr uint32_t kReplicasPerHalf = shared::kReplicas / kHalves;

    /// Black, of width * height > 0 pixels; `unit` is a power of two, as filmUnit gives it.
    /// `hasAlpha`: the background is hidden from the camera.
    AdaptiveFilm(uint32_t width, uint32_t height, double unit,
                 ReplicaDetail detail = ReplicaDetail::Luminance, bool hasAlpha = false);

    /// Adds a block to all pixels that are not left out (a byte for each pixel, 0 or 1). It must be
    /// their next block of its half. Sums and losses are as for Film::addBlock.
    void addBlock(uint32_t block, std::span<const glm::vec4> blockSums,
                  std::span<const uint8_t> isLeftOut, const FilmLosses& losses = {});

    /// Radiance per pixel. `partialBlock`, if not empty, is like a block of `half`, but with any
    /// number of samples in each pixel that is not left out: it shows in the picture only.
    Image picture(uint32_t half = 0, std::span<const glm::vec4> partialBlock = {},
                  std::span<const uint8_t> isLeftOut = {}) const;

    /// Likewise the share of each pixel's samples that show a surface, as the mean of both halves;
    /// empty if the film has no alpha.
    std::vector<float> alpha(uint32_t half = 0, std::span<const glm::vec4> partialBlock = {},
                             std::span<const uint8_t> isLeftOut = {}) const;

    /// The radiance of one replica, over whole blocks. Needs ReplicaDetail::Color.
    Image replicaPicture(uint32_t replica) const;

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    size_t pixelCount() const { return halves_[0].blocks.size(); }
    const FilmLosses& losses() const { return losses_; }

    /// The number of samples of all pixels together.
    uint64_t samples() const { return samples_; }

    /// The number of blocks of a half that each pixel has.
    std::span<const uint32_t> blocksOf(uint32_t half) const { return halves_[half].blocks; }

    /// The estimates of a half when each pixel had 4 * 2^level blocks of it. All pixels must have
    /// that many.
    std::span<const SurveyPixel> survey(uint32_t half, uint32_t level) const;

    /// Frees the memory of the surveys below a level.
    void forgetSurveysBelow(uint32_t level);

    /// The number of a pixel's samples in one replica, and the sum of their luminance, W/(m^2 sr).
    uint64_t samplesOfReplica(uint32_t replica, size_t pixel) const;
    double replicaLuminance(uint32_t replica, size_t pixel) const {
        return unit_ * fromFixedPoint(luminances_[replica * pixelCount() + pixel]);
    }

private:
    struct Half {
        FixedPointArray colors;        ///< R, G and B of the first pixel, of the second, ...
        FixedPointArray hiddenSamples; ///< as Film::Sums::hiddenSamples
        std::vector<uint32_t> blocks;
        std::vector<std::vector<SurveyPixel>> surveys; ///< by level; empty: not begun
    };

    void addTerms(uint32_t block, std::span<const glm::vec4> blockSums,
                  std::span<const uint8_t> isLeftOut);
    void recordSurvey(uint32_t half, size_t pixel);

    uint32_t width_;
    uint32_t height_;
    double unit_;
    std::array<Half, kHalves> halves_;
    FixedPointArray luminances_; ///< those of all pixels for replica 0, 1, ...
    /// R, G and B of all pixels for replica 0, 1, ...; empty with ReplicaDetail::Luminance.
    FixedPointArray replicaColors_;
    uint64_t samples_ = 0;
    uint32_t firstSurvey_ = 0; ///< lowest level that is kept
    FilmLosses losses_;
};

} // namespace calotype
