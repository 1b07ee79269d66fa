#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace calotype {

/// In pixels, of a picture that is rendered or compared.
inline constexpr uint32_t kLargestPictureSide = 65535;

/// Linear RGB picture, row by row from the top left pixel.
struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<glm::vec3> pixels; ///< width * height

    Image() = default;
    Image(uint32_t imageWidth, uint32_t imageHeight)
        : width(imageWidth), height(imageHeight), pixels(size_t{imageWidth} * imageHeight) {}

    glm::vec3& at(uint32_t x, uint32_t y) { return pixels[size_t{y} * width + x]; }
    const glm::vec3& at(uint32_t x, uint32_t y) const { return pixels[size_t{y} * width + x]; }
};

/// "640 x 480".
inline std::string sizeText(const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

} // namespace calotype
