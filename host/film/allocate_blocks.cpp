#include "film/allocate_blocks.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace calotype {
namespace {

/// Replaces each of `count` numbers, `stride` apart, by the sum of the numbers at most kReach
/// places away.
constexpr uint32_t kReach = 3;

void sumNeighbours(double* numbers, size_t count, size_t stride, std::vector<double>& scratch) {
    scratch.assign(count, 0.0);
    for (size_t i = 0; i < count; ++i) {
        const size_t first = i - std::min<size_t>(i, kReach);
        const size_t last = std::min(count - 1, i + kReach);
        for (size_t j = first; j <= last; ++j)
            scratch[i] += numbers[j * stride];
    }
    for (size_t i = 0; i < count; ++i)
        numbers[i * stride] = scratch[i];
}

/// Replaces each number by the mean of those of the 7 x 7 around it that are in the picture.
void smooth(std::vector<double>& numbers, uint32_t width) {
    const auto height = static_cast<uint32_t>(numbers.size() / width);
    std::vector<double> scratch;
    for (uint32_t y = 0; y < height; ++y)
        sumNeighbours(&numbers[size_t{y} * width], width, 1, scratch);
    for (uint32_t x = 0; x < width; ++x)
        sumNeighbours(&numbers[x], height, width, scratch);
    const auto reached = [](uint32_t i, uint32_t count) {
        return std::min(count - 1, i + kReach) - (i - std::min(i, kReach)) + 1;
    };
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            numbers[size_t{y} * width + x] /= reached(x, width) * reached(y, height);
}

/// The standard deviation of each pixel, relative to its luminance, up to a common factor.
std::vector<double> noiseOf(std::span<const SurveyPixel> survey, uint32_t width) {
    double brightness = 0.0;
    for (const SurveyPixel& pixel : survey)
        brightness += pixel.mean;
    const double floor = 0.01 * brightness / static_cast<double>(survey.size());
    std::vector<double> noise;
    noise.reserve(survey.size());
    for (const SurveyPixel& pixel : survey) {
        const double mean = pixel.mean;
        const double square = mean * mean + floor * floor;
        noise.push_back(square > 0.0 ? pixel.variance / square : 0.0);
    }
    smooth(noise, width);
    for (double& variance : noise)
        variance = std::sqrt(variance);
    return noise;
}

} // namespace

std::vector<uint32_t> allocateBlocks(std::span<const SurveyPixel> survey, uint32_t width,
                                     std::span<const uint32_t> least, uint32_t most,
                                     uint64_t total) {
    CALOTYPE_CHECK_EQ(survey.size(), least.size());
    CALOTYPE_CHECK_EQ(survey.size() % width, size_t{0});
    const std::vector<double> noise = noiseOf(survey, width);
    const auto shareOf = [&](size_t i, double perNoise) {
        return std::max<double>(least[i], std::min<double>(perNoise * noise[i], most));
    };
    const auto sumOf = [&](double perNoise) {
        double sum = 0.0;
        for (size_t i = 0; i < noise.size(); ++i)
            sum += shareOf(i, perNoise);
        return sum;
    };
    // The sum grows with the factor: find the one whose sum is the total.
    const double largest = *std::ranges::max_element(noise);
    double low = 0.0;
    double high = largest > 0.0 ? 1e9 * most / largest : 0.0;
    constexpr int kHalvings = 80; // of a range of 1e9, to a double's precision
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (sumOf(middle) <= static_cast<double>(total) ? low : high) = middle;
    }
    const double leftOver =
        std::max(0.0, static_cast<double>(total) - sumOf(low)) / static_cast<double>(noise.size());
    std::vector<uint32_t> blocks;
    blocks.reserve(noise.size());
    for (size_t i = 0; i < noise.size(); ++i)
        blocks.push_back(static_cast<uint32_t>(shareOf(i, low) + leftOver + 0.5));
    return blocks;
}

} // namespace calotype
