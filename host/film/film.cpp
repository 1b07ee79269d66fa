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

/// Whether a finite sum can enter the film.
bool isInRange(const glm::vec4& sum, double unit) {
    const float largest = std::max({std::abs(sum.r), std::abs(sum.g), std::abs(sum.b)});
    return double{largest} < kFixedPointTermLimit * unit;
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

Film::Sum& Film::Sum::operator+=(const Sum& other) {
    r += other.r;
    g += other.g;
    b += other.b;
    return *this;
}

glm::dvec3 Film::Sum::value() const {
    return {fromFixedPoint(r), fromFixedPoint(g), fromFixedPoint(b)};
}

Film::Film(uint32_t width, uint32_t height, double unit)
    : Film(width, height, unit,
           {{},
            std::vector<Sum>(size_t{width} * height),
            std::vector<FixedPoint>(size_t{width} * height * kReplicas),
            {}}) {}

Film::Film(uint32_t width, uint32_t height, double unit, Sums sums)
    : width_(width), height_(height), unit_(unit), sums_(std::move(sums)) {
    CALOTYPE_CHECK_LT(0u, pixelCount());
    CALOTYPE_CHECK_EQ(pixelCount(), size_t{width} * height);
    CALOTYPE_CHECK_EQ(sums_.luminances.size(), pixelCount() * kReplicas);
    CALOTYPE_CHECK_EQ(unit, filmUnit(unit));
}

void Film::addBlock(uint32_t block, std::span<const glm::vec4> blockSums,
                    const FilmLosses& losses) {
    CALOTYPE_CHECK_EQ(blockSums.size(), pixelCount());
    CALOTYPE_CHECK_LT(sums_.blocks.count(), kMaxBlocks);
    sums_.blocks.add({block, block + 1});
    sums_.losses += losses;
    const std::span<FixedPoint> luminances =
        std::span(sums_.luminances).subspan(block % kReplicas * pixelCount(), pixelCount());
    for (size_t i = 0; i < blockSums.size(); ++i) {
        CALOTYPE_CHECK_EQ(blockSums[i].w, float{kSamplesPerBlock});
        if (const auto term = toFilmTerm(blockSums[i], unit_, sums_.losses)) {
            sums_.colors[i] += term->color;
            luminances[i] += term->luminance;
        }
    }
}

void Film::add(const Film& other) {
    CALOTYPE_CHECK_EQ(width_, other.width_);
    CALOTYPE_CHECK_EQ(height_, other.height_);
    CALOTYPE_CHECK_EQ(unit_, other.unit_);
    sums_.blocks.add(other.sums_.blocks);
    CALOTYPE_CHECK_LE(sums_.blocks.count(), kMaxBlocks);
    for (size_t i = 0; i < pixelCount(); ++i)
        sums_.colors[i] += other.sums_.colors[i];
    for (size_t i = 0; i < sums_.luminances.size(); ++i)
        sums_.luminances[i] += other.sums_.luminances[i];
    sums_.losses += other.sums_.losses;
}

Image Film::picture(std::span<const glm::vec4> partialBlock) const {
    if (!partialBlock.empty())
        CALOTYPE_CHECK_EQ(partialBlock.size(), pixelCount());
    Image image(width_, height_);
    const auto samplesOfFilm = static_cast<double>(samplesPerPixel());
    for (size_t i = 0; i < pixelCount(); ++i) {
        glm::dvec3 sum = unit_ * sums_.colors[i].value();
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

uint64_t Film::samplesPerPixel() const { return blocks().count() * kSamplesPerBlock; }

uint64_t Film::samplesOfReplica(uint32_t replica) const {
    return blocks().countOf(replica, kReplicas) * kSamplesPerBlock;
}

} // namespace calotype
