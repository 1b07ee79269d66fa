#pragma once

#include <optional>

#include "render/render_session.h"
#include "support/device_tracer.h"

namespace calotype::test {

/// Films of one scene by seeds that follow each other. The device keeps the kernel, which does not
/// depend on the seed.
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
        settings.seed += count_++;
        DeviceTracer device(scene_, settings);
        AnySession session(device.tracer(), settings, device.packed().maxRadiance);
        session.run({}, 0, goal);
        return session.film();
    }

private:
    const Scene& scene_;
    RenderSettings settings_;
    uint32_t count_ = 0;
};

} // namespace calotype::test
