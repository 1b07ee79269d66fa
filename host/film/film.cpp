#include "film/film.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "film/block_count.h"
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

float shareOf(uint64_t part, uint64_t all) {
    return all == 0 ? 0.0f
                    : static_cast<float>(static_cast<double>(part) / static_cast<double>(all));
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

Film::Film(uint32_t width, uint32_t height, double unit, ReplicaDetail detail, bool hasAlpha)
    : Film(width, height, unit,
           {.blocks = {},
            .colors = FixedPointArray(kChannels * width * height),
            .luminances = FixedPointArray(size_t{kReplicas} * width * height),
            .replicaColors = FixedPointArray(
                detail == ReplicaDetail::Color ? kChannels * kReplicas * width * height : 0),
            .hiddenSamples = FixedPointArray(hasAlpha ? size_t{width} * height : 0),
            .losses = {}}) {}

Film::Film(uint32_t width, uint32_t height, double unit, Sums sums)
    : width_(width), height_(height), unit_(unit), sums_(std::move(sums)) {
    CALOTYPE_CHECK_LT(0u, pixelCount());
    CALOTYPE_CHECK_EQ(sums_.colors.size(), kChannels * pixelCount());
    CALOTYPE_CHECK_EQ(sums_.luminances.size(), kReplicas * pixelCount());
    if (detail() == ReplicaDetail::Color)
        CALOTYPE_CHECK_EQ(sums_.replicaColors.size(), kChannels * kReplicas * pixelCount());
    if (hasAlpha())
        CALOTYPE_CHECK_EQ(sums_.hiddenSamples.size(), pixelCount());
    CALOTYPE_CHECK_EQ(unit, filmUnit(unit));
}

void Film::addBlock(uint32_t block, std::span<const glm::vec4> blockSums,
                    const FilmLosses& losses) {
    CALOTYPE_CHECK_EQ(blockSums.size(), pixelCount());
    CALOTYPE_CHECK_LT(sums_.blocks.count(), kMaxBlocks);
    sums_.blocks.add({block, block + 1});
    sums_.losses += losses;
    const size_t firstOfReplica = block % kReplicas * pixelCount();
    FilmTerms terms;
    std::vector<FixedPoint> hidden;
    for (size_t first = 0; first < pixelCount(); first += FilmTerms::kMostPixels) {
        const size_t count = std::min(FilmTerms::kMostPixels, pixelCount() - first);
        terms.clear();
        hidden.clear();
        for (const glm::vec4& sum : blockSums.subspan(first, count)) {
            const BlockCount taken = blockCountOf(sum.w);
            CALOTYPE_CHECK_EQ(taken.samples, kSamplesPerBlock);
            CALOTYPE_CHECK_LE(taken.hidden, hasAlpha() ? kSamplesPerBlock : 0);
            hidden.push_back(taken.hidden);
            terms.add(toFilmTerm(sum, unit_, sums_.losses).value_or(FilmTerm{}));
        }
        if (hasAlpha())
            sums_.hiddenSamples.add(first, hidden);
        const std::span<const FixedPoint> colors = terms.colors();
        sums_.colors.add(kChannels * first, colors);
        sums_.luminances.add(firstOfReplica + first, terms.luminances());
        if (detail() == ReplicaDetail::Color)
            sums_.replicaColors.add(kChannels * (firstOfReplica + first), colors);
    }
}

void Film::add(const Film& other) {
    CALOTYPE_CHECK_EQ(width_, other.width_);
    CALOTYPE_CHECK_EQ(height_, other.height_);
    CALOTYPE_CHECK_EQ(unit_, other.unit_);
    CALOTYPE_CHECK_EQ(detail() == other.detail(), true);
    CALOTYPE_CHECK_EQ(hasAlpha(), other.hasAlpha());
    sums_.blocks.add(other.sums_.blocks);
    CALOTYPE_CHECK_LE(sums_.blocks.count(), kMaxBlocks);
    sums_.colors.add(other.sums_.colors);
    sums_.luminances.add(other.sums_.luminances);
    sums_.replicaColors.add(other.sums_.replicaColors);
    sums_.hiddenSamples.add(other.sums_.hiddenSamples);
    sums_.losses += other.sums_.losses;
}

Image Film::picture(std::span<const glm::vec4> partialBlock) const {
    if (!partialBlock.empty())
        CALOTYPE_CHECK_EQ(partialBlock.size(), pixelCount());
    Image image(width_, height_);
    const auto samplesOfFilm = static_cast<double>(samplesPerPixel());
    for (size_t i = 0; i < pixelCount(); ++i) {
        glm::dvec3 sum = unit_ * colorSum(sums_.colors, kChannels * i);
        double samples = samplesOfFilm;
        if (!partialBlock.empty()) {
            const glm::vec4& partial = partialBlock[i];
            CALOTYPE_CHECK_LE(0.0f, partial.w);
            samples += blockCountOf(partial.w).samples;
            if (isFinite(partial) && isInRange(partial, unit_))
                sum += glm::dvec3(partial);
        }
        image.pixels[i] = samples > 0.0 ? glm::vec3(sum / samples) : glm::vec3(0.0f);
    }
    return image;
}

std::vector<float> Film::alpha(std::span<const glm::vec4> partialBlock) const {
    std::vector<float> alpha(hasAlpha() ? pixelCount() : 0);
    for (size_t i = 0; i < alpha.size(); ++i) {
        const BlockCount partial =
            partialBlock.empty() ? BlockCount{} : blockCountOf(partialBlock[i].w);
        const uint64_t samples = samplesPerPixel() + partial.samples;
        const auto hidden = static_cast<uint64_t>(sums_.hiddenSamples[i]) + partial.hidden;
        alpha[i] = shareOf(samples - hidden, samples);
    }
    return alpha;
}

Image Film::replicaPicture(uint32_t replica) const {
    CALOTYPE_CHECK_LT(replica, kReplicas);
    CALOTYPE_CHECK_EQ(detail() == ReplicaDetail::Color, true);
    Image image(width_, height_);
    const uint64_t samples = samplesOfReplica(replica);
    if (samples == 0)
        return image;
    const double scale = unit_ / static_cast<double>(samples);
    for (size_t i = 0; i < pixelCount(); ++i)
        image.pixels[i] = glm::vec3(
            scale * colorSum(sums_.replicaColors, kChannels * (replica * pixelCount() + i)));
    return image;
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
