#include "image/texel_values.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "image/srgb.h"

namespace calotype {
namespace {

/// An image of the same size and form, with `grey` and `alpha` of each texel's value.
template <typename Grey, typename Alpha>
TexelImage makeImage(const TexelImage& image, TexelChannel channel, Grey grey, Alpha alpha) {
    TexelImage result;
    result.width = image.width;
    result.height = image.height;
    const auto fill = [&](auto& samples, auto toSample) {
        samples.resize(4 * image.texelCount());
        for (size_t i = 0; i < image.texelCount(); ++i) {
            const float value = texelValue(image, i, channel);
            std::fill_n(samples.begin() + 4 * i, 3, toSample(grey(value)));
            samples[4 * i + 3] = toSample(alpha(value));
            result.isTransparent = result.isTransparent || alpha(value) < 1.0f;
        }
    };
    if (image.holdsBytes())
        fill(result.bytes, [](float value) {
            return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
        });
    else
        fill(result.floats, [](float value) { return value; });
    return result;
}

/// The 256 values of a byte.
std::array<double, 256> valuesOfBytes(bool decode) {
    std::array<double, 256> values;
    for (size_t byte = 0; byte < values.size(); ++byte) {
        const double encoded = static_cast<double>(byte) / 255.0;
        values[byte] = decode ? linearFromSrgb(encoded) : encoded;
    }
    return values;
}

/// The mean of the three colours of all texels, see meanColor; `value` converts each sample of a
/// colour.
template <typename Sample, typename Value>
glm::dvec3 meanOf(const std::vector<Sample>& samples, Value value, AlphaWeights weights) {
    glm::dvec3 sum(0.0);
    glm::dvec3 weightedSum(0.0);
    double weight = 0.0;
    for (size_t i = 0; i < samples.size(); i += kTexelChannels) {
        const glm::dvec3 color(value(samples[i]), value(samples[i + 1]), value(samples[i + 2]));
        const auto alpha = static_cast<double>(samples[i + 3]);
        sum += color;
        weightedSum += alpha * color;
        weight += alpha;
    }
    if (weights == AlphaWeights::Yes && weight > 0.0)
        return weightedSum / weight;
    return sum / static_cast<double>(samples.size() / kTexelChannels);
}

template <typename Sample>
TexelRange rangeOf(const std::vector<Sample>& samples, double scale) {
    std::array<Sample, kTexelChannels> least;
    std::copy_n(samples.begin(), kTexelChannels, least.begin());
    std::array<Sample, kTexelChannels> greatest = least;
    for (size_t i = 0; i < samples.size(); i += kTexelChannels)
        for (size_t channel = 0; channel < kTexelChannels; ++channel) {
            least[channel] = std::min(least[channel], samples[i + channel]);
            greatest[channel] = std::max(greatest[channel], samples[i + channel]);
        }
    return {scale * glm::dvec3(least[0], least[1], least[2]),
            scale * glm::dvec3(greatest[0], greatest[1], greatest[2])};
}

} // namespace

TexelImage greyImage(const TexelImage& image, TexelChannel channel) {
    return makeImage(
        image, channel, [](float value) { return value; }, [](float) { return 1.0f; });
}

TexelImage alphaImage(const TexelImage& image, TexelChannel channel) {
    return makeImage(
        image, channel, [](float) { return 1.0f; },
        [](float value) { return std::clamp(value, 0.0f, 1.0f); });
}

glm::dvec3 meanColor(const TexelImage& image, bool decode, AlphaWeights weights) {
    const bool decodes = decode && image.isEncoded;
    if (image.holdsBytes()) {
        const std::array<double, 256> values = valuesOfBytes(decodes);
        return meanOf(
            image.bytes, [&](uint8_t byte) { return values[byte]; }, weights);
    }
    const auto value = [&](float sample) { return decodes ? linearFromSrgb(sample) : sample; };
    return meanOf(image.floats, value, weights);
}

TexelRange texelRange(const TexelImage& image) {
    return image.holdsBytes() ? rangeOf(image.bytes, 1.0 / 255.0) : rangeOf(image.floats, 1.0);
}

} // namespace calotype
