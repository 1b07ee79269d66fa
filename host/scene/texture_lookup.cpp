#include "scene/texture_lookup.h"

#include <array>
#include <cmath>
#include <variant>

#include "image/srgb.h"

namespace calotype {
namespace {

bool isOdd(double whole) { return std::fmod(whole, 2.0) != 0.0; }

/// The texel in [0, count) that `index`, a whole number of any size, wraps to.
uint32_t wrapped(double index, uint32_t count, TextureWrap wrap) {
    const double n = count;
    if (wrap == TextureWrap::Clamp)
        return index <= 0.0 ? 0 : index >= n ? count - 1 : static_cast<uint32_t>(index);
    const double period = wrap == TextureWrap::Mirror ? 2.0 * n : n;
    const double remainder = std::fmod(index, period); // exact
    const double inPeriod = remainder < 0.0 ? remainder + period : remainder;
    return static_cast<uint32_t>(inPeriod < n ? inPeriod : period - 1.0 - inPeriod);
}

/// Texels of an image by column and row, rows from the bottom up.
class TexelGrid {
public:
    TexelGrid(const ImageTexture& texture, bool decodes)
        : image_(*texture.image), wrap_(texture.wrap), decodes_(decodes && image_.isEncoded) {}

    glm::dvec4 at(double column, double row) const {
        const size_t x = wrapped(column, image_.width, wrap_);
        const size_t y = image_.height - 1 - wrapped(row, image_.height, wrap_);
        const size_t index = y * image_.width + x;
        const auto color = [&](int channel) {
            const double value = component(index, channel);
            return decodes_ ? linearFromSrgb(value) : value;
        };
        return {color(0), color(1), color(2), component(index, 3)};
    }

private:
    double component(size_t index, int channel) const {
        const size_t at = 4 * index + static_cast<size_t>(channel);
        return image_.holdsBytes() ? image_.bytes[at] / 255.0 : image_.floats[at];
    }

    const TexelImage& image_;
    TextureWrap wrap_;
    bool decodes_;
};

/// The four texels whose filters reach a position, and where it lies between them.
struct Neighbours {
    std::array<glm::dvec4, 4> texels; ///< bottom left, bottom right, top left, top right
    double toRight = 0.0;
    double toTop = 0.0;
};

Neighbours neighboursOf(const ImageTexture& texture, const glm::dvec2& uv, bool decodes) {
    const TexelGrid grid(texture, decodes && texture.decodesColor);
    const double x = uv.x * texture.image->width;
    const double y = uv.y * texture.image->height;
    Neighbours result;
    if (texture.filter == TextureFilter::Nearest) {
        result.texels.fill(grid.at(std::floor(x), std::floor(y)));
        return result;
    }
    const double left = std::floor(x - 0.5);
    const double bottom = std::floor(y - 0.5);
    result.texels = {grid.at(left, bottom), grid.at(left + 1.0, bottom),
                     grid.at(left, bottom + 1.0), grid.at(left + 1.0, bottom + 1.0)};
    result.toRight = x - 0.5 - left;
    result.toTop = y - 0.5 - bottom;
    return result;
}

glm::dvec4 filtered(const Neighbours& of) {
    const auto row = [&](const glm::dvec4& left, const glm::dvec4& right) {
        return (1.0 - of.toRight) * left + of.toRight * right;
    };
    return (1.0 - of.toTop) * row(of.texels[0], of.texels[1]) +
           of.toTop * row(of.texels[2], of.texels[3]);
}

glm::dvec4 lookUp(const ImageTexture& texture, const glm::dvec2& uv, bool decodes) {
    return filtered(neighboursOf(texture, uv, decodes));
}

glm::dvec4 lookUp(const CheckerTexture& checker, const glm::dvec2& uv, bool) {
    const bool isOddField = isOdd(std::floor(uv.x)) != isOdd(std::floor(uv.y));
    return glm::dvec4(checker.colors[isOddField ? 1 : 0], 1.0);
}

/// `value`, or 0 if it is too large to multiply with the size of an image.
double inRange(double value) { return std::abs(value) < 1e300 ? value : 0.0; }

glm::dvec2 sourcePosition(const Texture& texture, const glm::dvec2& uv) {
    const glm::dvec2 moved = uv * texture.scale + texture.offset;
    return {inRange(moved.x), inRange(moved.y)};
}

} // namespace

glm::dvec4 lookUp(const Texture& texture, const glm::dvec2& uv, bool decodes) {
    return std::visit(
        [&](const auto& source) { return lookUp(source, sourcePosition(texture, uv), decodes); },
        texture.source);
}

glm::dvec3 lookUpCutOutColor(const Texture& texture, const glm::dvec2& uv) {
    const auto& image = std::get<ImageTexture>(texture.source);
    const Neighbours plain = neighboursOf(image, sourcePosition(texture, uv), true);
    Neighbours weighted = plain;
    for (glm::dvec4& texel : weighted.texels)
        texel = glm::dvec4(texel.w * glm::dvec3(texel), texel.w);
    const glm::dvec4 sum = filtered(weighted);
    return sum.w > 0.0 ? glm::dvec3(sum) / sum.w : glm::dvec3(filtered(plain));
}

double lookUpScalar(const Texture& texture, const glm::dvec2& uv) {
    return lookUp(texture, uv, false).x;
}

} // namespace calotype
