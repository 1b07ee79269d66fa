#pragma once

#include <chrono>
#include <vector>

#include <glm/vec3.hpp>

#include "reference/reference_tracer.h"
#include "render/block_tracer.h"
#include "settings/render_settings.h"

namespace calotype {

/// Renders blocks of samples with the reference tracer, on threads of the CPU.
class ReferenceBlock : public BlockTracer {
public:
    /// `threads` >= 1. The tracer must outlive this object.
    ReferenceBlock(const reference::ReferenceTracer& tracer, const RenderSettings& settings,
                   uint32_t threads);

    uint32_t tileCount() const override;
    void beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut = {}) override;
    /// Renders for about a fifth of a second.
    shared::RenderCounters renderTiles(TileRange tiles, uint32_t sampleEnd) override;
    std::span<const glm::vec4> readBlock() override;

private:
    struct Pixel {
        glm::dvec3 sum{0.0};
        uint32_t sampleCount = 0;
        uint32_t hiddenCount = 0; ///< of these, samples that show nothing
    };

    /// Renders a pixel until it has `sampleEnd` samples, or until `deadline`; at least one sample
    /// if the counters have none.
    void renderPixel(glm::uvec2 position, uint32_t sampleEnd,
                     std::chrono::steady_clock::time_point deadline,
                     shared::RenderCounters& counters);

    const reference::ReferenceTracer& tracer_;
    RenderSettings settings_;
    uint32_t threads_;
    uint32_t firstSample_ = 0;
    std::vector<Pixel> pixels_;
    std::vector<glm::vec4> block_;
};

} // namespace calotype
