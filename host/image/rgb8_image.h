#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/gtc/type_precision.hpp>

namespace calotype {

/// Picture for a display: 8 bits of sRGB-encoded R, G and B, row by row from the top left pixel.
struct Rgb8Image {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<glm::u8vec3> pixels; ///< width * height

    Rgb8Image() = default;
    Rgb8Image(uint32_t imageWidth, uint32_t imageHeight)
        : width(imageWidth), height(imageHeight), pixels(size_t{imageWidth} * imageHeight) {}

    glm::u8vec3& at(uint32_t x, uint32_t y) { return pixels[size_t{y} * width + x]; }
    const glm::u8vec3& at(uint32_t x, uint32_t y) const { return pixels[size_t{y} * width + x]; }
};

} // namespace calotype
