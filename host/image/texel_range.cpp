#include "image/texel_range.h"

#include <algorithm>
#include <array>

namespace calotype {
namespace {

constexpr size_t kChannels = 4;

template <typename Sample>
TexelRange rangeOf(const std::vector<Sample>& samples, double scale) {
    std::array<Sample, kChannels> least;
    std::copy_n(samples.begin(), kChannels, least.begin());
    std::array<Sample, kChannels> greatest = least;
    for (size_t i = 0; i < samples.size(); i += kChannels)
        for (size_t channel = 0; channel < kChannels; ++channel) {
            least[channel] = std::min(least[channel], samples[i + channel]);
            greatest[channel] = std::max(greatest[channel], samples[i + channel]);
        }
    return {scale * glm::dvec3(least[0], least[1], least[2]),
            scale * glm::dvec3(greatest[0], greatest[1], greatest[2])};
}

} // namespace

TexelRange texelRange(const TexelImage& image) {
    return image.holdsBytes() ? rangeOf(image.bytes, 1.0 / 255.0) : rangeOf(image.floats, 1.0);
}

} // namespace calotype
