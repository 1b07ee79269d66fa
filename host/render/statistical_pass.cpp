#include "render/statistical_pass.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

#include <glm/common.hpp>

#include "base/parallel_for.h"
#include "base/stopwatch.h"
#include "kernels/denoiser_mix.spv.h"
#include "kernels/denoiser_sums.spv.h"
#include "math/square.h"
#include "render/tiles.h"
#include "shared/bindings.h"
#include "shared/denoise_structs.h"

namespace calotype {
namespace {

/// Side of the part of the picture that is denoised at once, pixels: 35 MB on the device.
constexpr uint32_t kWindow = 512;

/// What a part depends on: the colours of pixels a radius away, and their sums of weights, which
/// depend on the pixels a radius away from those.
constexpr uint32_t kMargin = 2 * shared::kDenoiserRadius;

/// The pixels of the largest window with its margins.
uint64_t windowPixels(uint32_t width, uint32_t height) {
    return uint64_t{std::min(width, kWindow + 2 * kMargin)} *
           std::min(height, kWindow + 2 * kMargin);
}

/// A window with its margins, as far as they are in the picture.
Crop withMargins(const Crop& inner, uint32_t width, uint32_t height) {
    const uint32_t left = inner.x - std::min(inner.x, kMargin);
    const uint32_t top = inner.y - std::min(inner.y, kMargin);
    const uint32_t right = std::min(inner.x + inner.width + kMargin, width);
    const uint32_t bottom = std::min(inner.y + inner.height + kMargin, height);
    return {left, top, right - left, bottom - top};
}

/// A power of two that brings the largest number to [1, 2): then no square exceeds the range of a
/// float, and only what is 2^63 times smaller falls below it.
double scaleOf(const NoisyImage& noisy) {
    float largest = 0.0f;
    for (const Image* image : {&noisy.color, &noisy.standardError})
        for (const glm::vec3& pixel : image->pixels)
            largest = std::max({largest, pixel.r, pixel.g, pixel.b});
    return largest > 0.0f ? std::ldexp(1.0, -std::ilogb(largest)) : 1.0;
}

std::vector<PixelStatistics> scaled(std::vector<PixelStatistics> statistics, double scale) {
    for (PixelStatistics& pixel : statistics) {
        pixel.color *= scale;
        pixel.patchColor *= scale;
        pixel.variance *= scale * scale;
        pixel.patchVariance *= scale * scale;
    }
    return statistics;
}

vk::BufferUsageFlags storage() { return vk::BufferUsageFlagBits::eStorageBuffer; }

} // namespace

StatisticalPass::StatisticalPass(const Device& device, DenoiserFeatures features, uint32_t threads)
    : device_(device), features_(std::move(features)), threads_(threads > 0 ? threads : allCores()),
      sums_(device, windowPixels(features_.albedo.width, features_.albedo.height) * sizeof(float),
            storage(), Buffer::Memory::Device, "sums of weights"),
      clean_(device,
             windowPixels(features_.albedo.width, features_.albedo.height) * sizeof(glm::vec4),
             storage(), Buffer::Memory::Host, "denoised pixels"),
      sizer_(shared::kMostTilesPerDispatch) {}

Image StatisticalPass::run(const NoisyImage& noisy) {
    const double scale = scaleOf(noisy);
    const auto statistics = scaled(pixelStatistics(noisy, features_, threads_), scale);
    const auto squaredBound = static_cast<float>(square(differenceBound(noisy.replicas)));
    Image image(noisy.color.width, noisy.color.height);
    for (uint32_t top = 0; top < image.height; top += kWindow)
        for (uint32_t left = 0; left < image.width; left += kWindow)
            denoise({left, top, std::min(kWindow, image.width - left),
                     std::min(kWindow, image.height - top)},
                    statistics, squaredBound, image);
    for (glm::vec3& pixel : image.pixels)
        pixel = glm::vec3(glm::dvec3(pixel) / scale);
    return image;
}

void StatisticalPass::denoise(const Crop& inner, const std::vector<PixelStatistics>& statistics,
                              float squaredBound, Image& image) {
    const Crop window = withMargins(inner, image.width, image.height);
    const TexelBuffer pixels = upload(window, statistics);
    std::vector<Binding> bindings = {Binding::texelBuffer(shared::kBindingNoisyPixels, pixels),
                                     Binding::storageBuffer(shared::kBindingWeightSums, sums_)};
    dispatch("denoiser sums", kDenoiserSumsSpirv, bindings, window, squaredBound);
    bindings.push_back(Binding::storageBuffer(shared::kBindingCleanPixels, clean_));
    dispatch("denoiser mix", kDenoiserMixSpirv, bindings, window, squaredBound);
    const std::span<const glm::vec4> clean = clean_.mapped<glm::vec4>();
    for (uint32_t y = inner.y; y < inner.y + inner.height; ++y)
        for (uint32_t x = inner.x; x < inner.x + inner.width; ++x)
            image.at(x, y) = glm::vec3(clean[size_t{y - window.y} * window.width + (x - window.x)]);
}

TexelBuffer StatisticalPass::upload(const Crop& window,
                                    const std::vector<PixelStatistics>& statistics) const {
    std::vector<shared::DenoiserPixel> pixels;
    pixels.reserve(size_t{window.width} * window.height);
    for (uint32_t y = window.y; y < window.y + window.height; ++y)
        for (uint32_t x = window.x; x < window.x + window.width; ++x) {
            const PixelStatistics& pixel = statistics[size_t{y} * features_.albedo.width + x];
            shared::DenoiserPixel packed{};
            packed.color.mean = glm::vec3(pixel.color);
            packed.color.variance = glm::vec3(pixel.variance);
            packed.patchColor.mean = glm::vec3(pixel.patchColor);
            packed.patchColor.variance = glm::vec3(pixel.patchVariance);
            packed.guides.albedo = features_.albedo.at(x, y);
            packed.guides.normal = features_.normal.at(x, y);
            pixels.push_back(packed);
        }
    return {device_, std::as_bytes(std::span(pixels)), "noisy pixels"};
}

void StatisticalPass::dispatch(const char* name, std::span<const uint32_t> spirv,
                               const std::vector<Binding>& bindings, const Crop& window,
                               float squaredBound) {
    const ComputePipeline pipeline(device_,
                                   {.name = name,
                                    .spirv = spirv,
                                    .bindings = bindings,
                                    .constants = {},
                                    .pushConstantBytes = sizeof(shared::DenoiserParameters)});
    shared::DenoiserParameters parameters{};
    parameters.windowSize = {window.width, window.height};
    parameters.squaredBound = squaredBound;
    const uint32_t tiles = countTiles(window);
    while (parameters.firstTile < tiles) {
        const uint32_t count = std::min(sizer_.tiles(), tiles - parameters.firstTile);
        const auto start = std::chrono::steady_clock::now();
        pipeline.run(device_, count, std::as_bytes(std::span(&parameters, 1)));
        sizer_.update(count, secondsSince(start));
        parameters.firstTile += count;
    }
}

uint64_t statisticalPassBytes(uint32_t width, uint32_t height) {
    return windowPixels(width, height) *
           (sizeof(shared::DenoiserPixel) + sizeof(float) + sizeof(glm::vec4));
}

} // namespace calotype
