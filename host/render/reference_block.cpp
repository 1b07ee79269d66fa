#include "render/reference_block.h"

#include <algorithm>
#include <cmath>

#include "base/parallel_for.h"
#include "render/tiles.h"

namespace calotype {
namespace {

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void add(gpu::RenderCounters& sum, const gpu::RenderCounters& counters) {
    sum.rays += counters.rays;
    sum.paths += counters.paths;
    sum.nonFiniteSamples += counters.nonFiniteSamples;
}

} // namespace

ReferenceBlock::ReferenceBlock(const reference::ReferenceTracer& tracer,
                               const RenderSettings& settings, uint32_t threads)
    : tracer_(tracer), settings_(settings), threads_(threads),
      pixels_(size_t{settings.crop.width} * settings.crop.height) {}

uint32_t ReferenceBlock::tileCount() const { return countTiles(settings_.crop); }

void ReferenceBlock::beginBlock(uint32_t firstSample) {
    firstSample_ = firstSample;
    std::ranges::fill(pixels_, Pixel{});
}

gpu::RenderCounters ReferenceBlock::renderTiles(TileRange tiles, uint32_t sampleEnd) {
    std::vector<gpu::RenderCounters> counters(threads_, gpu::RenderCounters{});
    parallelFor(tiles.first, tiles.first + tiles.count, threads_,
                [&](uint32_t tile, uint32_t thread) {
                    add(counters[thread], renderTile(tile, sampleEnd));
                });
    gpu::RenderCounters sum{};
    for (const gpu::RenderCounters& part : counters)
        add(sum, part);
    return sum;
}

gpu::RenderCounters ReferenceBlock::renderTile(uint32_t tile, uint32_t sampleEnd) {
    const Crop& crop = settings_.crop;
    const uint32_t x = tile % tilesAlong(crop.width) * gpu::kTileSize;
    const uint32_t y = tile / tilesAlong(crop.width) * gpu::kTileSize;
    gpu::RenderCounters counters{};
    for (uint32_t j = y; j < std::min(y + gpu::kTileSize, crop.height); ++j)
        for (uint32_t i = x; i < std::min(x + gpu::kTileSize, crop.width); ++i)
            add(counters, renderPixel({i, j}, sampleEnd));
    return counters;
}

gpu::RenderCounters ReferenceBlock::renderPixel(glm::uvec2 position, uint32_t sampleEnd) {
    const Crop& crop = settings_.crop;
    Pixel& pixel = pixels_[size_t{position.y} * crop.width + position.x];
    gpu::RenderCounters counters{};
    for (; pixel.sampleCount < sampleEnd; ++pixel.sampleCount) {
        const auto [radiance, rays] =
            tracer_.trace({position + glm::uvec2(crop.x, crop.y), firstSample_ + pixel.sampleCount,
                           settings_.seed});
        const bool finite = isFinite(radiance);
        pixel.sum += finite ? radiance : glm::dvec3(0.0);
        counters.rays += rays;
        ++counters.paths;
        counters.nonFiniteSamples += finite ? 0 : 1;
    }
    return counters;
}

std::span<const glm::vec4> ReferenceBlock::readBlock() {
    block_.resize(pixels_.size());
    std::ranges::transform(pixels_, block_.begin(), [](const Pixel& pixel) {
        return glm::vec4(pixel.sum, static_cast<float>(pixel.sampleCount));
    });
    return block_;
}

} // namespace calotype
