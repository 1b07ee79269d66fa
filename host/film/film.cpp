#include "film/film.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "math/luminance.h"

namespace calotype {
namespace {

using shared::kReplicas;
using shared::kSamplesPerBlock;

bool isFinite(const glm::vec4& sum) {
    return std::isfinite(sum.r) && std::isfinite(sum.g) && std::isfinite(sum.b);
}

/// Whether a sum can enter the film; false for one that is not finite.
bool isInRange(float sum, double unit) {
    return double{std::abs(sum)} < kFixedPointTermLimit * unit;
}

/// Likewise for all of a finite colour.
bool isInRange(const glm::vec4& sum, double unit) {
    return isInRange(std::max({std::abs(sum.r), std::abs(sum.g), std::abs(sum.b)}), unit);
}

} // namespace

double filmUnit(double maxRadiance) {
    CALOTYPE_CHECK_LE(0.0, maxRadiance);
    CALOTYPE_CHECK_EQ(std::isfinite(maxRadiance), true);
    if (maxRadiance == 0.0)
        return 1.0;
    int exponent = 0;
    const bool isPowerOfTwo = std::frexp(maxRadiance, &exponent) == 0.5;
    return std::ldexp(1.0, std::clamp(isPowerOfTwo ? exponent - 1 : exponent, -126, 127));
}

FilmLosses& FilmLosses::operator+=(const FilmLosses& other) {
    nonFiniteSamples += other.nonFiniteSamples;
    cutPaths += other.cutPaths;
    nonFinitePixels += other.nonFinitePixels;
    overflowedPixels += other.overflowedPixels;
    return *this;
}

Film::Film(uint32_t width, uint32_t height, double unit, const std::vector<std::string>& others)
    : Film(width, height, unit,
           {{},
            FixedPointArray(size_t{width} * height * (kColorChannels + others.size())),
            FixedPointArray(size_t{width} * height * kReplicas),
            {}},
           others) {}

Film::Film(uint32_t width, uint32_t height, double unit, Sums sums,
           const std::vector<std::string>& others)
    : width_(width), height_(height), unit_(unit), channels_{"R", "G", "B"},
      sums_(std::move(sums)) {
    channels_.insert(channels_.end(), others.begin(), others.end());
    CALOTYPE_CHECK_LT(0u, pixelCount());
    CALOTYPE_CHECK_EQ(sums_.channels.size(), pixelCount() * channels_.size());
    CALOTYPE_CHECK_EQ(sums_.luminances.size(), pixelCount() * kReplicas);
    CALOTYPE_CHECK_EQ(unit, filmUnit(unit));
}

void Film::addBlock(uint32_t block, std::span<const glm::vec4> blockSums, const FilmLosses& losses,
                    std::span<const float> otherSums) {
    const size_t others = channels_.size() - kColorChannels;
    CALOTYPE_CHECK_EQ(blockSums.size(), pixelCount());
    CALOTYPE_CHECK_EQ(otherSums.size(), pixelCount() * others);
    CALOTYPE_CHECK_LT(sums_.blocks.count(), kMaxBlocks);
    sums_.blocks.add({block, block + 1});
    sums_.losses += losses;
    const size_t firstLuminance = block % kReplicas * pixelCount();
    // Pixels are added by the size of a chunk, so that each chunk of the sums is changed once.
    std::vector<FixedPoint> channelTerms;
    std::vector<FixedPoint> luminanceTerms;
    for (size_t first = 0; first < pixelCount(); first += FixedPointArray::kChunkNumbers) {
        const size_t end = std::min(first + FixedPointArray::kChunkNumbers, pixelCount());
        channelTerms.clear();
        luminanceTerms.clear();
        for (size_t i = first; i < end; ++i) {
            CALOTYPE_CHECK_EQ(blockSums[i].w, float{kSamplesPerBlock});
            const FilmTerm term =
                toFilmTerm(blockSums[i], unit_, sums_.losses).value_or(FilmTerm{});
            channelTerms.insert(channelTerms.end(), term.color.begin(), term.color.end());
            luminanceTerms.push_back(term.luminance);
            for (const float sum : otherSums.subspan(i * others, others))
                channelTerms.push_back(isInRange(sum, 1.0) ? toFixedPoint(sum) : 0);
        }
        sums_.channels.add(first * channels_.size(), channelTerms);
        sums_.luminances.add(firstLuminance + first, luminanceTerms);
    }
}

void Film::add(const Film& other) {
    CALOTYPE_CHECK_EQ(width_, other.width_);
    CALOTYPE_CHECK_EQ(height_, other.height_);
    CALOTYPE_CHECK_EQ(unit_, other.unit_);
    CALOTYPE_CHECK_EQ(channels_ == other.channels_, true);
    sums_.blocks.add(other.sums_.blocks);
    CALOTYPE_CHECK_LE(sums_.blocks.count(), kMaxBlocks);
    sums_.channels.add(other.sums_.channels);
    sums_.luminances.add(other.sums_.luminances);
    sums_.losses += other.sums_.losses;
}

Image Film::picture(std::span<const glm::vec4> partialBlock) const {
    if (!partialBlock.empty())
        CALOTYPE_CHECK_EQ(partialBlock.size(), pixelCount());
    Image image(width_, height_);
    const auto samplesOfFilm = static_cast<double>(samplesPerPixel());
    for (size_t i = 0; i < pixelCount(); ++i) {
        glm::dvec3 sum = unit_ * colorSum(sums_.channels, i * channels_.size());
        double samples = samplesOfFilm;
        if (!partialBlock.empty()) {
            const glm::vec4& partial = partialBlock[i];
            CALOTYPE_CHECK_LE(0.0f, partial.w);
            samples += partial.w;
            if (isFinite(partial) && isInRange(partial, unit_))
                sum += glm::dvec3(partial);
        }
        image.pixels[i] = samples > 0.0 ? glm::vec3(sum / samples) : glm::vec3(0.0f);
    }
    return image;
}

std::vector<float> Film::mean(size_t channel) const {
    CALOTYPE_CHECK_LT(channel, channels_.size());
    std::vector<float> means(pixelCount());
    const uint64_t samples = samplesPerPixel();
    if (samples == 0)
        return means;
    const double scale = (channel < kColorChannels ? unit_ : 1.0) / static_cast<double>(samples);
    for (size_t i = 0; i < means.size(); ++i) {
        const FixedPoint sum = sums_.channels[i * channels_.size() + channel];
        means[i] = static_cast<float>(scale * fromFixedPoint(sum));
    }
    return means;
}

std::optional<FilmTerm> toFilmTerm(const glm::vec4& blockSum, double unit, FilmLosses& losses) {
    if (!isFinite(blockSum)) {
        ++losses.nonFinitePixels;
        return std::nullopt;
    }
    if (!isInRange(blockSum, unit)) {
        ++losses.overflowedPixels;
        return std::nullopt;
    }
    const glm::dvec3 units = glm::dvec3(blockSum) / unit; // exact: a power of two
    return FilmTerm{{toFixedPoint(units.r), toFixedPoint(units.g), toFixedPoint(units.b)},
                    toFixedPoint(luminance(units))};
}

glm::dvec3 colorSum(const FixedPointArray& sums, size_t red) {
    return {fromFixedPoint(sums[red]), fromFixedPoint(sums[red + 1]),
            fromFixedPoint(sums[red + 2])};
}

uint64_t Film::samplesPerPixel() const { return blocks().count() * kSamplesPerBlock; }

uint64_t Film::samplesOfReplica(uint32_t replica) const {
    return blocks().countOf(replica, kReplicas) * kSamplesPerBlock;
}

} // namespace calotype
