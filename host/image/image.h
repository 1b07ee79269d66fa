#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>

namespace calotype {

/// The longest side of pictures to render or compare, in pixels.
inline constexpr uint32_t kLargestPictureSide = 65535;

/// A value for each pixel, row by row from the top left one.
template <typename Pixel>
struct PixelGrid {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<Pixel> pixels; ///< width * height

    PixelGrid() = default;
    PixelGrid(uint32_t gridWidth, uint32_t gridHeight)
        : width(gridWidth), height(gridHeight), pixels(size_t{gridWidth} * gridHeight) {}

    Pixel& at(uint32_t x, uint32_t y) { return pixels[size_t{y} * width + x]; }
    const Pixel& at(uint32_t x, uint32_t y) const { return pixels[size_t{y} * width + x]; }
};

/// Linear RGB.
using Image = PixelGrid<glm::vec3>;

/// For a display: 8 bits of sRGB-encoded R, G and B.
using Rgb8Image = PixelGrid<glm::u8vec3>;

/// "640 x 480".
template <typename Pixel>
std::string sizeText(const PixelGrid<Pixel>& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

} // namespace calotype
