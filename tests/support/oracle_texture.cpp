#include "support/oracle_texture.h"

#include <algorithm>
#include <cmath>

namespace calotype::test {
namespace {

int64_t remainder(int64_t i, int64_t period) { return (i % period + period) % period; }

/// The column or row of the image that stands at place i of the lattice.
int64_t texelAt(int64_t i, int64_t count, TextureWrap wrap) {
    switch (wrap) {
    case TextureWrap::Clamp:
        return std::clamp<int64_t>(i, 0, count - 1);
    case TextureWrap::Mirror:
        return std::min(remainder(i, 2 * count), 2 * count - 1 - remainder(i, 2 * count));
    case TextureWrap::Repeat:
        break;
    }
    return remainder(i, count);
}

/// Column i and row j of the lattice, which counts rows from the bottom.
glm::dvec4 latticeTexel(const ImageTexture& texture, int64_t i, int64_t j, bool decode) {
    const TexelImage& image = *texture.image;
    const int64_t column = texelAt(i, image.width, texture.wrap);
    const int64_t row = image.height - 1 - texelAt(j, image.height, texture.wrap);
    const auto first = static_cast<size_t>(4 * (row * image.width + column));
    glm::dvec4 texel;
    for (int channel = 0; channel < 4; ++channel) {
        texel[channel] = image.holdsBytes() ? image.bytes[first + channel] / 255.0
                                            : static_cast<double>(image.floats[first + channel]);
        if (channel < 3 && decode && texture.decodesColor && image.isEncoded)
            texel[channel] = oracleLinearFromSrgb(texel[channel]);
    }
    return texel;
}

/// Calls `use(share, texel)` for each texel that the filter reaches; the shares sum to 1.
template <typename Use>
void forEachTexel(const ImageTexture& texture, const glm::dvec2& position, bool decode,
                  const Use& use) {
    const double x = position.x * texture.image->width;
    const double y = position.y * texture.image->height;
    if (texture.filter == TextureFilter::Nearest) {
        use(1.0, latticeTexel(texture, std::llround(std::floor(x)), std::llround(std::floor(y)),
                              decode));
        return;
    }
    const int64_t left = std::llround(std::floor(x - 0.5));
    const int64_t bottom = std::llround(std::floor(y - 0.5));
    for (int64_t i = left; i <= left + 1; ++i)
        for (int64_t j = bottom; j <= bottom + 1; ++j)
            use((1.0 - std::abs(x - 0.5 - static_cast<double>(i))) *
                    (1.0 - std::abs(y - 0.5 - static_cast<double>(j))),
                latticeTexel(texture, i, j, decode));
}

glm::dvec4 imageAt(const ImageTexture& texture, const glm::dvec2& position, bool decode) {
    glm::dvec4 sum(0.0);
    forEachTexel(texture, position, decode,
                 [&](double share, const glm::dvec4& texel) { sum += share * texel; });
    return sum;
}

} // namespace

glm::dvec4 oracleTexture(const Texture& texture, const glm::dvec2& position, bool decode) {
    if (const auto* image = std::get_if<ImageTexture>(&texture.source))
        return imageAt(*image, position, decode);
    const auto& colors = std::get<CheckerTexture>(texture.source).colors;
    const int64_t field = std::llround(std::floor(position.x) + std::floor(position.y));
    return {colors[static_cast<size_t>(remainder(field, 2))], 1.0};
}

glm::dvec3 oracleCutOutColor(const Texture& texture, const glm::dvec2& position, bool decode) {
    const auto& source = std::get<ImageTexture>(texture.source);
    glm::dvec3 sum(0.0);
    double total = 0.0;
    forEachTexel(source, position, decode, [&](double share, const glm::dvec4& texel) {
        sum += share * texel.w * glm::dvec3(texel);
        total += share * texel.w;
    });
    return total > 0.0 ? sum / total : glm::dvec3(imageAt(source, position, decode));
}

double oracleLinearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace calotype::test
