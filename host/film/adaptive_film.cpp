#include "film/adaptive_film.h"

#include <algorithm>
#include <bit>

#include "base/check.h"
#include "film/block_count.h"

namespace calotype {
namespace {

using shared::kReplicas;
using shared::kSamplesPerBlock;

constexpr uint32_t kFirstSurveyBlocks = AdaptiveFilm::kReplicasPerHalf;

} // namespace

AdaptiveFilm::AdaptiveFilm(uint32_t width, uint32_t height, double unit, ReplicaDetail detail,
                           bool hasAlpha)
    : width_(width), height_(height), unit_(unit), luminances_(size_t{width} * height * kReplicas) {
    CALOTYPE_CHECK_EQ(unit, filmUnit(unit));
    for (Half& half : halves_) {
        half.colors = FixedPointArray(Film::kChannels * width * height);
        half.hiddenSamples = FixedPointArray(hasAlpha ? size_t{width} * height : 0);
        half.blocks.resize(size_t{width} * height);
    }
    if (detail == ReplicaDetail::Color)
        replicaColors_ = FixedPointArray(kReplicas * Film::kChannels * pixelCount());
    CALOTYPE_CHECK_LT(0u, pixelCount());
}

void AdaptiveFilm::addBlock(uint32_t block, std::span<const glm::vec4> blockSums,
                            std::span<const uint8_t> isLeftOut, const FilmLosses& losses) {
    CALOTYPE_CHECK_EQ(blockSums.size(), pixelCount());
    CALOTYPE_CHECK_EQ(isLeftOut.size(), pixelCount());
    CALOTYPE_CHECK_LT(block, Film::kMaxBlocks);
    losses_ += losses;
    addTerms(block, blockSums, isLeftOut);
    const uint32_t halfIndex = block % kHalves;
    std::vector<uint32_t>& blocks = halves_[halfIndex].blocks;
    for (size_t i = 0; i < pixelCount(); ++i) {
        if (isLeftOut[i] != 0)
            continue;
        CALOTYPE_CHECK_EQ(blocks[i], block / kHalves);
        CALOTYPE_CHECK_EQ(blockCountOf(blockSums[i].w).samples, kSamplesPerBlock);
        samples_ += kSamplesPerBlock;
        if (++blocks[i] >= kFirstSurveyBlocks && std::has_single_bit(blocks[i]))
            recordSurvey(halfIndex, i);
    }
}

void AdaptiveFilm::addTerms(uint32_t block, std::span<const glm::vec4> blockSums,
                            std::span<const uint8_t> isLeftOut) {
    const size_t firstOfReplica = block % kReplicas * pixelCount();
    FixedPointArray& hiddenSamples = halves_[block % kHalves].hiddenSamples;
    FilmTerms terms;
    std::vector<FixedPoint> hidden;
    for (size_t first = 0; first < pixelCount(); first += FilmTerms::kMostPixels) {
        const size_t end = std::min(first + FilmTerms::kMostPixels, pixelCount());
        terms.clear();
        hidden.clear();
        for (size_t i = first; i < end; ++i) {
            FilmTerm term;
            if (isLeftOut[i] == 0)
                term = toFilmTerm(blockSums[i], unit_, losses_).value_or(FilmTerm{});
            terms.add(term);
            hidden.push_back(isLeftOut[i] == 0 ? blockCountOf(blockSums[i].w).hidden : 0);
        }
        if (hiddenSamples.size() > 0)
            hiddenSamples.add(first, hidden);
        halves_[block % kHalves].colors.add(Film::kChannels * first, terms.colors());
        luminances_.add(firstOfReplica + first, terms.luminances());
        if (replicaColors_.size() > 0)
            replicaColors_.add(Film::kChannels * (firstOfReplica + first), terms.colors());
    }
}

/// All replicas of the half must have the same number of samples in the pixel.
void AdaptiveFilm::recordSurvey(uint32_t half, size_t pixel) {
    const auto level =
        static_cast<uint32_t>(std::countr_zero(halves_[half].blocks[pixel] / kFirstSurveyBlocks));
    if (level < firstSurvey_)
        return;
    auto& surveys = halves_[half].surveys;
    if (surveys.size() <= level)
        surveys.resize(level + 1);
    if (surveys[level].empty())
        surveys[level].resize(pixelCount());
    std::array<double, kReplicasPerHalf> means{};
    double mean = 0.0;
    for (uint32_t i = 0; i < kReplicasPerHalf; ++i) {
        const uint32_t replica = kHalves * i + half;
        means[i] = fromFixedPoint(luminances_[replica * pixelCount() + pixel]) /
                   static_cast<double>(samplesOfReplica(replica, pixel));
        mean += means[i] / kReplicasPerHalf;
    }
    double squares = 0.0;
    for (const double replicaMean : means)
        squares += (replicaMean - mean) * (replicaMean - mean);
    surveys[level][pixel] = {
        static_cast<float>(mean),
        static_cast<float>(squares / (kReplicasPerHalf * (kReplicasPerHalf - 1)))};
}

std::span<const SurveyPixel> AdaptiveFilm::survey(uint32_t half, uint32_t level) const {
    CALOTYPE_CHECK_LE(firstSurvey_, level);
    CALOTYPE_CHECK_LE(kFirstSurveyBlocks << level, *std::ranges::min_element(blocksOf(half)));
    return halves_[half].surveys[level];
}

void AdaptiveFilm::forgetSurveysBelow(uint32_t level) {
    firstSurvey_ = std::max(firstSurvey_, level);
    for (Half& half : halves_)
        for (uint32_t i = 0; i < std::min<size_t>(level, half.surveys.size()); ++i)
            half.surveys[i] = {};
}

uint64_t AdaptiveFilm::samplesOfReplica(uint32_t replica, size_t pixel) const {
    const uint32_t blocks = halves_[replica % kHalves].blocks[pixel];
    const uint32_t inHalf = replica / kHalves; // its blocks are inHalf, inHalf + 4, ... of the half
    return uint64_t{kSamplesPerBlock} *
           ((blocks + kReplicasPerHalf - 1 - inHalf) / kReplicasPerHalf);
}

Image AdaptiveFilm::picture(uint32_t half, std::span<const glm::vec4> partialBlock,
                            std::span<const uint8_t> isLeftOut) const {
    Image image(width_, height_);
    for (size_t i = 0; i < pixelCount(); ++i) {
        glm::dvec3 means(0.0);
        double count = 0.0; // halves that have samples
        for (uint32_t h = 0; h < kHalves; ++h) {
            glm::dvec3 sum = unit_ * colorSum(halves_[h].colors, Film::kChannels * i);
            double samples = double{kSamplesPerBlock} * halves_[h].blocks[i];
            if (h == half && !partialBlock.empty() && isLeftOut[i] == 0) {
                FilmLosses ignored;
                samples += blockCountOf(partialBlock[i].w).samples;
                if (toFilmTerm(partialBlock[i], unit_, ignored))
                    sum += glm::dvec3(partialBlock[i]);
            }
            if (samples > 0.0) {
                means += sum / samples;
                count += 1.0;
            }
        }
        image.pixels[i] = count > 0.0 ? glm::vec3(means / count) : glm::vec3(0.0f);
    }
    return image;
}

std::vector<float> AdaptiveFilm::alpha(uint32_t half, std::span<const glm::vec4> partialBlock,
                                       std::span<const uint8_t> isLeftOut) const {
    const bool hasAlpha = halves_[0].hiddenSamples.size() > 0;
    std::vector<float> alpha(hasAlpha ? pixelCount() : 0);
    for (size_t i = 0; i < alpha.size(); ++i) {
        double shares = 0.0;
        double count = 0.0; // halves that have samples
        for (uint32_t h = 0; h < kHalves; ++h) {
            BlockCount partial;
            if (h == half && !partialBlock.empty() && isLeftOut[i] == 0)
                partial = blockCountOf(partialBlock[i].w);
            const double samples =
                double{kSamplesPerBlock} * halves_[h].blocks[i] + partial.samples;
            const double hidden = static_cast<double>(halves_[h].hiddenSamples[i]) + partial.hidden;
            if (samples > 0.0) {
                shares += 1.0 - hidden / samples;
                count += 1.0;
            }
        }
        alpha[i] = count > 0.0 ? static_cast<float>(shares / count) : 0.0f;
    }
    return alpha;
}

Image AdaptiveFilm::replicaPicture(uint32_t replica) const {
    CALOTYPE_CHECK_LT(replica, kReplicas);
    CALOTYPE_CHECK_LT(size_t{0}, replicaColors_.size());
    Image image(width_, height_);
    for (size_t i = 0; i < pixelCount(); ++i)
        if (const uint64_t samples = samplesOfReplica(replica, i))
            image.pixels[i] =
                glm::vec3(unit_ / static_cast<double>(samples) *
                          colorSum(replicaColors_, Film::kChannels * (replica * pixelCount() + i)));
    return image;
}

} // namespace calotype
