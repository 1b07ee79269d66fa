#include "scene/texture_lookup.h"

#include <cmath>

namespace calotype {
namespace {

bool isOdd(double whole) { return std::fmod(whole, 2.0) != 0.0; }

/// The index in [0, count) of the texel that stands for `index`, a whole number of any size.
uint32_t wrapped(double index, uint32_t count, TextureWrap wrap) {
    const double n = count;
    if (wrap == TextureWrap::Clamp) {
        return index <= 0.0 ? 0 : index >= n ? count - 1 : static_cast<uint32_t>(index);
    }
    const double period = wrap == TextureWrap::Mirror ? 2.0 * n : n;
    const double remainder = std::fmod(index, period); // exact
    const double inPeriod = remainder < 0.0 ? remainder + period : remainder;
    return static_cast<uint32_t>(inPeriod < n ? inPeriod : period - 1.0 - inPeriod);
}

/// Texels of an image by column and row, rows from the bottom up.
class TexelGrid {
public:
    explicit TexelGrid(const ImageTexture& texture) : image_(*texture.image), wrap_(texture.wrap) {}

    double at(double column, double row) const {
        const size_t x = wrapped(column, image_.width, wrap_);
        const size_t y = image_.height - 1 - wrapped(row, image_.height, wrap_);
        const size_t first = 4 * (y * image_.width + x);
        return image_.holdsBytes() ? image_.bytes[first] / 255.0 : image_.floats[first];
    }

private:
    const TexelImage& image_;
    TextureWrap wrap_;
};

double lookUp(const ImageTexture& texture, const glm::dvec2& uv) {
    const TexelGrid grid(texture);
    const double x = uv.x * texture.image->width;
    const double y = uv.y * texture.image->height;
    if (texture.filter == TextureFilter::Nearest) {
        return grid.at(std::floor(x), std::floor(y));
    }
    const double left = std::floor(x - 0.5);
    const double bottom = std::floor(y - 0.5);
    const double toRight = x - 0.5 - left;
    const double toTop = y - 0.5 - bottom;
    const auto rowAt = [&](double row) {
        return (1.0 - toRight) * grid.at(left, row) + toRight * grid.at(left + 1.0, row);
    };
    return (1.0 - toTop) * rowAt(bottom) + toTop * rowAt(bottom + 1.0);
}

double lookUp(const CheckerTexture& checker, const glm::dvec2& uv) {
    return checker.colors[isOdd(std::floor(uv.x)) != isOdd(std::floor(uv.y)) ? 1 : 0].x;
}

/// `value`, where the size of an image that multiplies it cannot take it out of range.
double inRange(double value) { return std::abs(value) < 1e300 ? value : 0.0; }

} // namespace

double lookUpScalar(const Texture& texture, const glm::dvec2& uv) {
    const glm::dvec2 moved = uv * texture.scale + texture.offset;
    const glm::dvec2 finite(inRange(moved.x), inRange(moved.y));
    return std::visit([&](const auto& source) { return lookUp(source, finite); }, texture.source);
}

} // namespace calotype
