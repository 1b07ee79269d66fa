#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "film/block_ranges.h"
#include "film/film_losses.h"
#include "film/fixed_point.h"
#include "film/fixed_point_array.h"
#include "image/image.h"
#include "shared/limits.h"

namespace calotype {

/// The unit of a film's colours: the least power of two at or above the scene's largest emitted
/// radiance, a finite number >= 0; kept within 2^-126 and 2^127, and 1 for a scene without light.
double filmUnit(double maxRadiance);

/// The samples of a picture so far, summed per pixel and channel in fixed point of 128 bits, 64 of
/// them below one unit; also the luminance of each replica. So films are bit for bit the same
/// whatever the order of their blocks, and large sums lose no small terms.
///
/// The first three channels are R, G and B, radiance in W/(m^2 sr), in the film's unit. A film can
/// have more: the means of other quantities over the same samples, in units of 1.
///
/// Block b holds the samples of absolute indices from 16 b on, and belongs to replica b mod 8
/// (shared::kSamplesPerBlock and shared::kReplicas). Replicas are independent of each other.
///
/// Range: the sum of one block is added exactly from 2^-41 units up, and to within 2^-65 units
/// below; it must be below 2^40 units. A film's sum must be below 2^63 units, so 2^23 blocks fit.
class Film {
public:
    static constexpr uint64_t kMaxBlocks = uint64_t{1} << 23;
    static constexpr size_t kColorChannels = 3; ///< R, G and B

    /// What a film holds, row by row from the top left pixel, in units.
    struct Sums {
        BlockRanges blocks;
        FixedPointArray channels;   ///< all of the first pixel, all of the second, ...
        FixedPointArray luminances; ///< those of all pixels for replica 0, 1, ...
        FilmLosses losses;

        bool operator==(const Sums&) const = default;
    };

    /// A black film of width * height > 0 pixels; `unit` is a power of two, as filmUnit gives it.
    /// `others` are the names of its channels beside R, G and B.
    Film(uint32_t width, uint32_t height, double unit, const std::vector<std::string>& others = {});

    /// A film that was written before; the sums must have its size.
    Film(uint32_t width, uint32_t height, double unit, Sums sums,
         const std::vector<std::string>& others = {});

    /// Adds a whole block that it does not hold yet: per pixel, row by row, the sum of r, g, b over
    /// shared::kSamplesPerBlock samples, and that number in w. A pixel whose sum is not finite, or
    /// is 2^40 units or more, adds nothing, but its samples count; it is added to the losses, and
    /// so are the `losses` of the block's samples. `otherSums` are those of the other channels, all
    /// of the first pixel, all of the second, ...; one that is not finite, or is 2^40 or more, adds
    /// nothing.
    void addBlock(uint32_t block, std::span<const glm::vec4> blockSums,
                  const FilmLosses& losses = {}, std::span<const float> otherSums = {});

    /// Adds a film of the same size, unit and channels that holds none of the same blocks.
    void add(const Film& other);

    /// Mean radiance per pixel; black if there is no sample. `partialBlock`, if not empty, is like
    /// a block, but with any number of samples in each pixel: it is in the picture only.
    Image picture(std::span<const glm::vec4> partialBlock = {}) const;

    /// Mean of a channel per pixel, over whole blocks; 0 if there is no sample.
    std::vector<float> mean(size_t channel) const;

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    size_t pixelCount() const { return size_t{width_} * height_; }
    double unit() const { return unit_; }
    /// Their names, the first three of which are "R", "G" and "B".
    const std::vector<std::string>& channels() const { return channels_; }
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
    std::vector<std::string> channels_;
    Sums sums_;
};

/// The contribution of a pixel's block sum to a film, in units.
struct FilmTerm {
    std::array<FixedPoint, 3> color{}; ///< R, G, B
    FixedPoint luminance = 0;
};

/// None if the sum is not finite or out of a film's range: then it is counted in `losses`.
std::optional<FilmTerm> toFilmTerm(const glm::vec4& blockSum, double unit, FilmLosses& losses);

/// R, G and B of a pixel, in units: three sums, the first of which has index `red`.
glm::dvec3 colorSum(const FixedPointArray& sums, size_t red);

} // namespace calotype
