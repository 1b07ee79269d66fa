#include "engine/renderer.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/warnings.h"
#include "check/validate.h"
#include "engine/loss_warnings.h"
#include "engine/make_session.h"
#include "engine/render_engine.h"
#include "engine/scene_settings.h"

namespace calotype {
namespace {

using Clock = std::chrono::steady_clock;

RenderEnd endOf(RenderEnding ending) {
    switch (ending) {
    case RenderEnding::AllSamples:
        return RenderEnd::AllSamples;
    case RenderEnding::TargetError:
        return RenderEnd::TargetError;
    case RenderEnding::Deadline:
        return RenderEnd::Time;
    case RenderEnding::Stopped:
        break;
    }
    return RenderEnd::Stopped;
}

RenderGoal goalOf(const RenderSettings& settings, Clock::time_point start) {
    RenderGoal goal;
    goal.targetError = settings.targetError;
    if (settings.seconds)
        goal.deadline = start + std::chrono::duration_cast<Clock::duration>(
                                    std::chrono::duration<double>(*settings.seconds));
    return goal;
}

/// A scene that was read from a file has a hash, and was already checked.
Scene checked(Scene scene) {
    if (scene.hash == 0) {
        Warnings warnings;
        validate(scene, warnings);
        scene.warnings = warnings.sentences();
    }
    return scene;
}

std::vector<float> floatsOf(const Image& image) {
    std::vector<float> floats;
    floats.reserve(3 * image.pixels.size());
    for (const glm::vec3& pixel : image.pixels)
        floats.insert(floats.end(), {pixel.r, pixel.g, pixel.b});
    return floats;
}

} // namespace

struct Renderer::State {
    Scene scene;
    DeviceOptions device;
};

Renderer::Renderer(Scene scene, DeviceOptions device)
    : state_(std::make_unique<State>(State{checked(std::move(scene)), std::move(device)})) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Scene& Renderer::scene() const { return state_->scene; }

RenderSettings Renderer::defaultSettings() const { return calotype::defaultSettings(scene()); }

RenderResult Renderer::render(const RenderSettings& settings, const RenderCallbacks& callbacks) {
    const Clock::time_point start = Clock::now();
    requireRenderable(settings, state_->device);
    const auto shouldStop = [&] { return callbacks.shouldStop && callbacks.shouldStop(); };
    const auto report = [&](const std::string& what, double done) {
        if (callbacks.onProgress)
            callbacks.onProgress(what, done);
    };
    const auto prepare = [&](const std::string& what, double done) {
        if (shouldStop())
            throw Interrupted();
        report(what, done);
    };
    const TextureFilterOverride filters(state_->scene, settings.textureFilter);
    StageSeconds seconds;
    const auto engine =
        makeEngine(state_->device, state_->scene, {settings, false, prepare}, seconds);
    if (shouldStop())
        throw Interrupted();
    const auto session = makeSession(engine->tracer(), settings, engine->maxRadiance());

    const auto allPaths = static_cast<double>(session->samplesInTheEnd()) * settings.crop.width *
                          settings.crop.height;
    RenderObserver observer;
    observer.shouldStop = shouldStop;
    observer.onDispatch = [&](const RenderTotals& totals) {
        report("rendering", std::min(1.0, static_cast<double>(totals.paths) / allPaths));
    };
    const RenderEnding ending = session->run(observer, 0, goalOf(settings, start));
    const auto& error = session->error();
    const RenderTotals& totals = session->totals();
    engine->finish();

    RenderResult result;
    result.width = settings.crop.width;
    result.height = settings.crop.height;
    result.pixels = floatsOf(session->picture());
    result.samplesPerPixel = totals.samplesPerPixel;
    result.end = endOf(ending);
    result.seconds = totals.seconds;
    if (error) {
        result.relativeError = error->relative;
        result.isErrorTrusted = error->isTrusted();
    }
    result.warnings = state_->scene.warnings;
    for (std::string& warning : lossWarnings(totals.losses))
        result.warnings.push_back(std::move(warning));
    return result;
}

} // namespace calotype
