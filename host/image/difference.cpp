#include "image/difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "base/check.h"
#include "base/error.h"

namespace calotype {
namespace {

bool hasNan(const glm::vec3& pixel) {
    return std::isnan(pixel.x) || std::isnan(pixel.y) || std::isnan(pixel.z);
}

void requireNoNan(const Image& image, const std::string& name) {
    const auto count = std::count_if(image.pixels.begin(), image.pixels.end(), hasNan);
    if (count == 0)
        return;
    const auto first = static_cast<size_t>(
        std::find_if(image.pixels.begin(), image.pixels.end(), hasNan) - image.pixels.begin());
    throw SceneError(name, std::to_string(count) + " of " + std::to_string(image.pixels.size()) +
                               " pixels are NaN, the first at (" +
                               std::to_string(first % image.width) + ", " +
                               std::to_string(first / image.width) +
                               ") from the top left; such a picture cannot be compared");
}

struct Sums {
    glm::dvec3 error{0.0};
    double squaredError = 0.0;
    double relativeSquaredError = 0.0;
};

/// Adds one pixel of each picture; both must be finite.
void add(Sums& sums, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 error = a - b;
    sums.error += error;
    sums.squaredError += glm::dot(error, error);
    for (int channel = 0; channel < 3; ++channel)
        sums.relativeSquaredError += relativeSquaredError(a[channel], b[channel]);
}

} // namespace

double relativeSquaredError(double a, double b) {
    constexpr double kFloor = 0.01;
    return (a - b) * (a - b) / (b * b + kFloor);
}

bool isFinite(const glm::vec3& pixel) {
    return std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z);
}

double ImageDifference::psnr() const {
    if (rmse == 0.0)
        return std::numeric_limits<double>::infinity();
    return 20.0 * std::log10(peak / rmse);
}

void requireComparable(const Image& a, const std::string& nameA, const Image& b,
                       const std::string& nameB) {
    if (a.width != b.width || a.height != b.height)
        throw SceneError(nameA, "the picture has " + sizeText(a) + " pixels and '" + nameB +
                                    "' has " + sizeText(b) +
                                    "; only pictures of one size can be compared");
    requireNoNan(a, nameA);
    requireNoNan(b, nameB);
    for (size_t i = 0; i < a.pixels.size(); ++i)
        if (isFinite(a.pixels[i]) && isFinite(b.pixels[i]))
            return;
    throw SceneError(nameA, "no pixel is finite both here and in '" + nameB +
                                "', so there is nothing to compare");
}

ImageDifference measureDifference(const Image& a, const Image& b) {
    CALOTYPE_CHECK_EQ(a.width, b.width);
    CALOTYPE_CHECK_EQ(a.height, b.height);
    ImageDifference result;
    Sums sums;
    for (uint32_t y = 0; y < a.height; ++y)
        for (uint32_t x = 0; x < a.width; ++x) {
            const glm::vec3& pixelA = a.at(x, y);
            const glm::vec3& pixelB = b.at(x, y);
            result.infiniteInA += isFinite(pixelA) ? 0 : 1;
            result.infiniteInB += isFinite(pixelB) ? 0 : 1;
            if (!isFinite(pixelA) || !isFinite(pixelB)) {
                ++result.leftOut;
                continue;
            }
            add(sums, glm::dvec3(pixelA), glm::dvec3(pixelB));
            for (int channel = 0; channel < 3; ++channel) {
                const double error = std::abs(double{pixelA[channel]} - pixelB[channel]);
                if (error > result.largest.magnitude)
                    result.largest = {error, x, y, channel};
                result.peak = std::max(result.peak, double{pixelB[channel]});
            }
        }
    const auto pixels = static_cast<double>(a.pixels.size() - result.leftOut);
    result.meanError = sums.error / pixels;
    result.rmse = std::sqrt(sums.squaredError / (3.0 * pixels));
    result.relativeMse = sums.relativeSquaredError / (3.0 * pixels);
    return result;
}

} // namespace calotype
