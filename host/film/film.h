#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "film/block_ranges.h"
#include "film/film_losses.h"
#include "film/fixed_point.h"
#include "film/fixed_point_array.h"
#include "image/image.h"
#include "settings/denoiser_kind.h"
#include "shared/limits.h"

namespace calotype {

/// The unit of a film's colours: the least power of two at or above the scene's largest emitted
/// radiance, a finite number >= 0; kept within 2^-126 and 2^127, and 1 for a scene without light.
double filmUnit(double maxRadiance);

/// What a film keeps of each replica: its luminance, by which errors are estimated, or also its
/// colour, by which denoised pictures are judged.
enum class ReplicaDetail : uint8_t { Luminance, Color };

/// What pictures need that this denoiser makes.
constexpr ReplicaDetail detailFor(DenoiserKind denoiser) {
    return denoiser == DenoiserKind::Off ? ReplicaDetail::Luminance : ReplicaDetail::Color;
}

/// The samples of a picture so far, summed per pixel and channel in fixed point of 128 bits, 64 of
/// them below one unit; also the luminance of each replica. So films are bit for bit the same
/// whatever the order of their blocks, and large sums lose no small terms.
///
/// Sums are radiance in W/(m^2 sr), in the film's unit.
///
/// Block b holds the samples of absolute indices from 16 b on, and belongs to replica b mod 8
/// (shared::kSamplesPerBlock and shared::kReplicas). Replicas are independent of each other.
///
/// Range: the sum of one block is added exactly from 2^-41 units up, and to within 2^-65 units
/// below; it must be below 2^40 units. A film's sum must be below 2^63 units, so 2^23 blocks fit.
class Film {
public:
    static constexpr uint64_t kMaxBlocks = uint64_t{1} << 23;
    static constexpr size_t kChannels = 3; ///< R, G and B

    /// What a film holds, row by row from the top left pixel, in units.
    struct Sums {
        BlockRanges blocks;
        FixedPointArray colors;     ///< R, G and B of the first pixel, of the second, ...
        FixedPointArray luminances; ///< those of all pixels for replica 0, 1, ...
        /// R, G and B of all pixels for replica 0, 1, ...; empty with ReplicaDetail::Luminance.
        FixedPointArray replicaColors;
        /// The number of samples of each pixel that show the background where it is hidden from the
        /// camera; empty where it is not.
        FixedPointArray hiddenSamples;
        FilmLosses losses;

        bool operator==(const Sums&) const = default;
    };

    /// A black film of width * height > 0 pixels; `unit` is a power of two, as filmUnit gives it.
    /// `hasAlpha`: the background is hidden from the camera.
    Film(uint32_t width, uint32_t height, double unit,
         ReplicaDetail detail = ReplicaDetail::Luminance, bool hasAlpha = false);

    /// A film that was written before; the sums must have its size.
    Film(uint32_t width, uint32_t height, double unit, Sums sums);

    /// Adds a whole block that it does not hold yet: per pixel, row by row, the sum of r, g, b over
    /// shared::kSamplesPerBlock samples, and that number in w (film/block_count.h). A pixel whose
    /// sum is not finite, or is 2^40 units or more, adds nothing, but its samples count; it is
    /// added to the losses, and so are the `losses` of the block's samples.
    void addBlock(uint32_t block, std::span<const glm::vec4> blockSums,
                  const FilmLosses& losses = {});

    /// Adds a film of the same size, unit, detail and alpha that holds none of the same blocks.
    void add(const Film& other);

    /// Mean radiance per pixel; black if there is no sample. `partialBlock`, if not empty, is like
    /// a block, but with any number of samples in each pixel: it is in the picture only.
    Image picture(std::span<const glm::vec4> partialBlock = {}) const;

    /// Likewise the share of each pixel's samples that show a surface; 0 if there is no sample.
    /// Empty if the film has no alpha.
    std::vector<float> alpha(std::span<const glm::vec4> partialBlock = {}) const;

    /// Likewise of one replica, over whole blocks. Needs ReplicaDetail::Color.
    Image replicaPicture(uint32_t replica) const;

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    size_t pixelCount() const { return size_t{width_} * height_; }
    double unit() const { return unit_; }
    ReplicaDetail detail() const {
        return sums_.replicaColors.size() > 0 ? ReplicaDetail::Color : ReplicaDetail::Luminance;
    }
    bool hasAlpha() const { return sums_.hiddenSamples.size() > 0; }
    const Sums& sums() const { return sums_; }
    const BlockRanges& blocks() const { return sums_.blocks; }
    const FilmLosses& losses() const { return sums_.losses; }
    uint64_t samplesPerPixel() const;

    /// The number of samples per pixel of one replica.
    uint64_t samplesOfReplica(uint32_t replica) const;

    /// Sum of a pixel's luminance over the samples of a replica, W/(m^2 sr).
    double replicaLuminance(uint32_t replica, size_t pixel) const {
        return unit_ * fromFixedPoint(sums_.luminances[replica * pixelCount() + pixel]);
    }

private:
    uint32_t width_;
    uint32_t height_;
    double unit_;
    Sums sums_;
};

/// The contribution of a pixel's block sum to a film, in units.
struct FilmTerm {
    std::array<FixedPoint, 3> color{}; ///< R, G, B
    FixedPoint luminance = 0;
};

/// None if the sum is not finite or out of a film's range: then it is counted in `losses`.
std::optional<FilmTerm> toFilmTerm(const glm::vec4& blockSum, double unit, FilmLosses& losses);

/// The terms of consecutive pixels, as many as change each chunk of a film's sums once.
class FilmTerms {
public:
    static constexpr size_t kMostPixels = FixedPointArray::kChunkNumbers;

    void clear() { count_ = 0; }

    /// Of at most kMostPixels pixels.
    void add(const FilmTerm& term) {
        std::ranges::copy(term.color, &colors_[Film::kChannels * count_]);
        luminances_[count_++] = term.luminance;
    }

    /// R, G and B of the first pixel, of the second, ...
    std::span<const FixedPoint> colors() const {
        return std::span(colors_).first(Film::kChannels * count_);
    }
    std::span<const FixedPoint> luminances() const { return std::span(luminances_).first(count_); }

private:
    std::array<FixedPoint, Film::kChannels * kMostPixels> colors_;
    std::array<FixedPoint, kMostPixels> luminances_;
    size_t count_ = 0;
};

/// R, G and B of a pixel, in units: three sums, the first of which has index `red`.
glm::dvec3 colorSum(const FixedPointArray& sums, size_t red);

} // namespace calotype
