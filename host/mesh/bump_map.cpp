#include "mesh/bump_map.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace calotype {
namespace {

constexpr double kGreyTolerance = 0.05;
constexpr double kMostMeanTilt = 0.1;
constexpr double kLeastMeanZ = 0.55;

/// With floats, because a flat surface has no exact code in bytes.
TexelImage emptyNormalMap(const TexelImage& image) {
    TexelImage result;
    result.width = image.width;
    result.height = image.height;
    result.floats.reserve(4 * image.texelCount());
    return result;
}

void appendNormal(TexelImage& image, const glm::dvec3& direction) {
    const glm::dvec3 color = 0.5 + 0.5 * glm::normalize(direction);
    for (int i = 0; i < 3; ++i)
        image.floats.push_back(static_cast<float>(color[i]));
    image.floats.push_back(1.0f);
}

} // namespace

bool isGrey(const TexelImage& image) {
    double sum = 0.0;
    for (size_t i = 0; i < image.texelCount(); ++i) {
        const auto [low, high] =
            std::minmax({texelComponent(image, i, 0), texelComponent(image, i, 1),
                         texelComponent(image, i, 2)});
        sum += high - low;
    }
    return sum <= kGreyTolerance * static_cast<double>(image.texelCount());
}

bool looksLikeNormals(const TexelImage& image) {
    const glm::dvec3 mean = 2.0 * meanColor(image, false) - 1.0;
    return std::abs(mean.x) < kMostMeanTilt && std::abs(mean.y) < kMostMeanTilt &&
           mean.z > kLeastMeanZ;
}

TexelImage normalMapFromHeights(const TexelImage& heights, TexelChannel channel, double steepness) {
    const uint32_t width = heights.width;
    const uint32_t height = heights.height;
    const auto heightAt = [&](uint32_t x, uint32_t y) {
        return double{texelValue(heights, size_t{y % height} * width + x % width, channel)};
    };
    TexelImage result = emptyNormalMap(heights);
    for (uint32_t y = 0; y < height; ++y) {
        for (uint32_t x = 0; x < width; ++x) {
            const double alongU = heightAt(x + 1, y) - heightAt(x + width - 1, y);
            const double alongV = heightAt(x, y + height - 1) - heightAt(x, y + 1); // v goes up
            appendNormal(result, {-0.5 * steepness * alongU, -0.5 * steepness * alongV, 1.0});
        }
    }
    return result;
}

TexelImage steepenedNormalMap(const TexelImage& normals, double steepness) {
    TexelImage result = emptyNormalMap(normals);
    for (size_t i = 0; i < normals.texelCount(); ++i) {
        glm::dvec3 n;
        for (int k = 0; k < 3; ++k)
            n[k] = 2.0 * texelComponent(normals, i, k) - 1.0;
        n = {n.x * steepness, n.y * steepness, n.z};
        appendNormal(result, n == glm::dvec3(0.0) ? glm::dvec3(0.0, 0.0, 1.0) : n);
    }
    return result;
}

} // namespace calotype
