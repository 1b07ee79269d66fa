#include "engine/renderer.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/warnings.h"
#include "check/validate.h"
#include "engine/device_session.h"
#include "engine/run_job.h"
#include "engine/scene_settings.h"

namespace calotype {
namespace {

/// Adds the warnings that the scene lacks.
Scene checked(Scene scene) {
    Warnings warnings;
    validate(scene, warnings);
    for (const std::string& warning : warnings.sentences())
        if (std::ranges::find(scene.warnings, warning) == scene.warnings.end())
            scene.warnings.push_back(warning);
    return scene;
}

} // namespace

struct Renderer::State {
    Scene scene;
    DeviceKeeper device;
};

Renderer::Renderer(LoadedScene scene, DeviceOptions device)
    : state_(std::make_unique<State>(State{std::move(scene), DeviceKeeper(std::move(device))})) {}
Renderer::Renderer(Scene scene, DeviceOptions device)
    : state_(std::make_unique<State>(
          State{checked(std::move(scene)), DeviceKeeper(std::move(device))})) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Scene& Renderer::scene() const { return state_->scene; }

RenderSettings Renderer::defaultSettings() const {
    RenderSettings settings = calotype::defaultSettings(scene());
    settings.crop = {}; // so that a changed size still gives the whole picture
    return settings;
}

RenderResult Renderer::render(const RenderSettings& settings, const RenderCallbacks& callbacks) {
    RenderJob job;
    job.settings = settings;
    return render(job, callbacks);
}

RenderResult Renderer::render(const RenderJob& job, const RenderCallbacks& callbacks) {
    try {
        return runJob(state_->scene, state_->device, job, callbacks);
    } catch (const GpuError&) {
        state_->device.forget();
        throw;
    }
}

} // namespace calotype
