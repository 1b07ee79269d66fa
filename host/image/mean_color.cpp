#include "image/mean_color.h"

#include <array>

#include "image/srgb.h"

namespace calotype {
namespace {

/// The 256 values of a byte.
std::array<double, 256> valuesOfBytes(bool decode) {
    std::array<double, 256> values;
    for (size_t byte = 0; byte < values.size(); ++byte) {
        const double encoded = static_cast<double>(byte) / 255.0;
        values[byte] = decode ? linearFromSrgb(encoded) : encoded;
    }
    return values;
}

/// Adds the three colours of each texel, `value` of each sample.
template <typename Sample, typename Value>
glm::dvec3 sumOf(const std::vector<Sample>& samples, Value value) {
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < samples.size(); i += 4)
        sum += glm::dvec3(value(samples[i]), value(samples[i + 1]), value(samples[i + 2]));
    return sum;
}

} // namespace

glm::dvec3 meanColor(const TexelImage& image, bool decode) {
    const bool decodes = decode && image.isEncoded;
    const auto count = static_cast<double>(image.texelCount());
    if (image.holdsBytes()) {
        const std::array<double, 256> values = valuesOfBytes(decodes);
        return sumOf(image.bytes, [&](uint8_t byte) { return values[byte]; }) / count;
    }
    const auto value = [&](float sample) { return decodes ? linearFromSrgb(sample) : sample; };
    return sumOf(image.floats, value) / count;
}

} // namespace calotype
