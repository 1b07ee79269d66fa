#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace calotype {

/// FirstHit::primitive where there is none.
inline constexpr uint32_t kNoPrimitive = ~0u;

/// The surface that a pixel shows: the first on the ray through the middle of the pixel and of the
/// lens, whatever the film's filter. Lights hidden from the camera, and points whose alpha is below
/// 1/2, are passed through. The defaults are a pixel that shows no surface.
struct FirstHit {
    /// Linear Rec. 709, in [0, 1]: a metal's F0, 1 for a dielectric, else the reflectance of the
    /// material's `color`, its texture looked up; of emitters too.
    glm::vec3 albedo{0.0f};
    /// Unit shading normal in the world, normal maps applied, turned to the viewer's side of the
    /// true surface.
    glm::vec3 normal{0.0f};
    glm::vec3 position{0.0f};                             ///< in the world, metres
    float depth = std::numeric_limits<float>::infinity(); ///< along the camera's axis, metres
    uint32_t primitive = kNoPrimitive;                    ///< number in the order of the scene file
    glm::vec2 uv{0.0f}; ///< texture coordinates; zero where a mesh has none
};

/// First hits of a picture, row by row from the top left pixel.
struct FirstHitImage {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<FirstHit> pixels; ///< width * height

    FirstHitImage() = default;
    FirstHitImage(uint32_t imageWidth, uint32_t imageHeight)
        : width(imageWidth), height(imageHeight), pixels(size_t{imageWidth} * imageHeight) {}

    FirstHit& at(uint32_t x, uint32_t y) { return pixels[size_t{y} * width + x]; }
    const FirstHit& at(uint32_t x, uint32_t y) const { return pixels[size_t{y} * width + x]; }
};

} // namespace calotype
