#include "render/reference_block.h"

#include <algorithm>
#include <cmath>

#include "base/parallel_for.h"
#include "film/block_count.h"
#include "render/tiles.h"

namespace calotype {
namespace {

void add(shared::RenderCounters& sum, const shared::RenderCounters& counters) {
    sum.rays += counters.rays;
    sum.paths += counters.paths;
    sum.nonFiniteSamples += counters.nonFiniteSamples;
    sum.unfinishedPixels += counters.unfinishedPixels;
}

} // namespace

ReferenceBlock::ReferenceBlock(const reference::ReferenceTracer& tracer,
                               const RenderSettings& settings, uint32_t threads)
    : tracer_(tracer), settings_(settings), threads_(threads),
      pixels_(size_t{settings.crop.width} * settings.crop.height) {}

uint32_t ReferenceBlock::tileCount() const { return countTiles(settings_.crop); }

void ReferenceBlock::beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut) {
    firstSample_ = firstSample;
    std::ranges::fill(pixels_, Pixel{});
    for (size_t i = 0; i < isLeftOut.size(); ++i)
        pixels_[i].sampleCount = isLeftOut[i] != 0 ? shared::kSamplesPerBlock : 0;
}

shared::RenderCounters ReferenceBlock::renderTiles(TileRange tiles, uint32_t sampleEnd) {
    constexpr auto kLongest = std::chrono::milliseconds(200); // so that interrupts take effect
    const auto deadline = std::chrono::steady_clock::now() + kLongest;
    const Crop& crop = settings_.crop;
    std::vector<shared::RenderCounters> counters(threads_, shared::RenderCounters{});
    const uint64_t first = uint64_t{tiles.first} * kPixelsPerTile;
    parallelFor(first, first + uint64_t{tiles.count} * kPixelsPerTile, threads_,
                [&](uint64_t index, uint32_t thread) {
                    const auto tile = static_cast<uint32_t>(index / kPixelsPerTile);
                    const auto inTile = static_cast<uint32_t>(index % kPixelsPerTile);
                    const glm::uvec2 corner(tile % tilesAlong(crop.width),
                                            tile / tilesAlong(crop.width));
                    const glm::uvec2 position =
                        shared::kTileSize * corner +
                        glm::uvec2(inTile % shared::kTileSize, inTile / shared::kTileSize);
                    if (position.x < crop.width && position.y < crop.height)
                        renderPixel(position, sampleEnd, deadline, counters[thread]);
                });
    shared::RenderCounters sum{};
    for (const shared::RenderCounters& part : counters)
        add(sum, part);
    return sum;
}

void ReferenceBlock::renderPixel(glm::uvec2 position, uint32_t sampleEnd,
                                 std::chrono::steady_clock::time_point deadline,
                                 shared::RenderCounters& counters) {
    const Crop& crop = settings_.crop;
    Pixel& pixel = pixels_[size_t{position.y} * crop.width + position.x];
    for (; pixel.sampleCount < sampleEnd; ++pixel.sampleCount) {
        if (counters.paths > 0 && std::chrono::steady_clock::now() > deadline) {
            ++counters.unfinishedPixels;
            return;
        }
        const reference::PathSample sample =
            tracer_.trace({position + glm::uvec2(crop.x, crop.y), firstSample_ + pixel.sampleCount,
                           settings_.seed, settings_.sampler});
        pixel.sum += sample.isFinite ? sample.radiance : glm::dvec3(0.0);
        pixel.hiddenCount += sample.showsNothing ? 1 : 0;
        counters.rays += sample.rays;
        ++counters.paths;
        counters.nonFiniteSamples += sample.isFinite ? 0 : 1;
    }
}

std::span<const glm::vec4> ReferenceBlock::readBlock() {
    block_.resize(pixels_.size());
    std::ranges::transform(pixels_, block_.begin(), [](const Pixel& pixel) {
        return glm::vec4(pixel.sum, blockCount({pixel.sampleCount, pixel.hiddenCount}));
    });
    return block_;
}

} // namespace calotype
