#pragma once

#include <optional>

#include "render/render_session.h"
#include "support/device_tracer.h"

namespace calotype::test {

/// Films of one scene from random numbers that are independent of each other.
///
/// Sobol's points are independent in other seeds only, each of which needs a kernel of its own.
/// Independent samples are so at other indices too: one kernel, which takes a third of a second to
/// compile, is enough for them.
class SeededFilms {
public:
    /// Keeps a reference to the scene.
    SeededFilms(const Scene& scene, const RenderSettings& settings)
        : scene_(scene), settings_(settings) {}
    SeededFilms(const Scene&&, const RenderSettings&) = delete;

    /// The next one, by a session of the kind, of the settings' samples unless others are given.
    template <typename AnySession>
    auto next(std::optional<uint32_t> samples = std::nullopt, const RenderGoal& goal = {}) {
        RenderSettings settings = settings_;
        settings.samplesPerPixel = samples.value_or(settings_.samplesPerPixel);
        const uint32_t index = count_++;
        if (settings.sampler == Sampler::Sobol) {
            settings.seed += index;
            device_.emplace(scene_, settings);
        } else if (!device_) {
            device_.emplace(scene_, settings);
        }
        LaterSamples tracer(device_->tracer(),
                            settings.sampler == Sampler::Sobol ? 0 : index * kMostSamples);
        AnySession session(tracer, settings, device_->packed().maxRadiance);
        session.run({}, 0, goal);
        return session.film();
    }

private:
    static constexpr uint32_t kMostSamples = 1u << 20; ///< of a film, at one pixel

    /// The tracer's samples from a later index on.
    class LaterSamples : public BlockTracer {
    public:
        LaterSamples(BlockTracer& tracer, uint32_t offset) : tracer_(tracer), offset_(offset) {}

        uint32_t tileCount() const override { return tracer_.tileCount(); }
        void beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut) override {
            tracer_.beginBlock(offset_ + firstSample, isLeftOut);
        }
        shared::RenderCounters renderTiles(TileRange tiles, uint32_t sampleEnd) override {
            return tracer_.renderTiles(tiles, sampleEnd);
        }
        std::span<const glm::vec4> readBlock() override { return tracer_.readBlock(); }

    private:
        BlockTracer& tracer_;
        uint32_t offset_;
    };

    const Scene& scene_;
    RenderSettings settings_;
    std::optional<DeviceTracer> device_;
    uint32_t count_ = 0;
};

} // namespace calotype::test
