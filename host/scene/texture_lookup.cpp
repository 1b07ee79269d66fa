#include "scene/texture_lookup.h"

#include <cmath>

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

glm::dvec4 lookUp(const ImageTexture& texture, const glm::dvec2& uv, bool decodes) {
    const TexelGrid grid(texture, decodes && texture.decodesColor);
    const double x = uv.x * texture.image->width;
    const double y = uv.y * texture.image->height;
    if (texture.filter == TextureFilter::Nearest)
        return grid.at(std::floor(x), std::floor(y));
    const double left = std::floor(x - 0.5);
    const double bottom = std::floor(y - 0.5);
    const double toRight = x - 0.5 - left;
    const double toTop = y - 0.5 - bottom;
    const auto rowAt = [&](double row) {
        return (1.0 - toRight) * grid.at(left, row) + toRight * grid.at(left + 1.0, row);
    };
    return (1.0 - toTop) * rowAt(bottom) + toTop * rowAt(bottom + 1.0);
}

glm::dvec4 lookUp(const CheckerTexture& checker, const glm::dvec2& uv, bool) {
    const bool isOddField = isOdd(std::floor(uv.x)) != isOdd(std::floor(uv.y));
    return glm::dvec4(checker.colors[isOddField ? 1 : 0], 1.0);
}

/// `value`, or 0 if it is too large to multiply with the size of an image.
double inRange(double value) { return std::abs(value) < 1e300 ? value : 0.0; }

} // namespace

glm::dvec4 lookUp(const Texture& texture, const glm::dvec2& uv, bool decodes) {
    const glm::dvec2 moved = uv * texture.scale + texture.offset;
    const glm::dvec2 finite(inRange(moved.x), inRange(moved.y));
    return std::visit([&](const auto& source) { return lookUp(source, finite, decodes); },
                      texture.source);
}

double lookUpScalar(const Texture& texture, const glm::dvec2& uv) {
    return lookUp(texture, uv, false).x;
}

} // namespace calotype
