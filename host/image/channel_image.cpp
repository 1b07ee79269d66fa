#include "image/channel_image.h"

#include <algorithm>
#include <cmath>

namespace calotype {
namespace {

/// Of the same size and form (bytes or floats), with `grey` and `alpha` of each texel's value.
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

} // namespace calotype
