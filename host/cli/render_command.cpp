#include "cli/commands.h"

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "cli/check_outputs.h"
#include "cli/device_environment.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/interrupt_deadline.h"
#include "cli/progress.h"
#include "cli/read_scene.h"
#include "cli/render_report.h"
#include "engine/render_job.h"
#include "engine/renderer.h"
#include "engine/scene_settings.h"
#include "engine/stage_seconds.h"
#include "settings/limits.h"

namespace calotype {
namespace {

/// Whether the number of samples ends the render: if it was given, or if nothing else does.
bool limitsSamples(const GivenSettings& given) {
    return given.has("spp") || given.has("samples") ||
           !(given.has("target_error") || given.has("time"));
}

RenderJob makeJob(const RenderOptions& options, const Renderer& renderer) {
    RenderJob job;
    job.settings = renderer.defaultSettings();
    job.limitsSamples = limitsSamples(options.settings);
    // If the user gave an error or a time, the scene's number of samples must not end the render
    // before.
    if (!job.limitsSamples)
        job.settings.samplesPerPixel = kMostSamplesPerPixel;
    options.settings.applyTo(job.settings);
    job.film = options.film;
    job.output = options.output;
    job.returnsPixels = false;
    return job;
}

/// One `calotype render`.
class RenderRun {
public:
    explicit RenderRun(const RenderOptions& options) : options_(options) {
        options_.device = withEnvironment(options.device, true);
    }

    int run() {
        OutputClaims claims = checkOutputs(options_);
        RenderSettings given;
        options_.settings.applyTo(given);
        requireKnownTo(options_.device, given);
        double loadSeconds = 0.0;
        deadline_.emplace(Interrupted().what());
        progress_.emplace(style());
        LoadedScene scene = timed(loadSeconds, [&] { return load(); });
        progress_->clear();
        claims.reserve(scene.files());
        Renderer renderer(std::move(scene), options_.device);
        printWarnings(renderer.scene());
        RenderJob job = makeJob(options_, renderer);
        job.start = start_;
        job.loadSeconds = loadSeconds;
        const RenderResult result = render(renderer, job);
        progress_->clear();
        progress_->finished(result.totals);
        reportRender(options_, result);
        return result.ending == RenderEnding::Stopped ? kExitOther : kExitDone;
    }

private:
    ProgressStyle style() const {
        return options_.quiet ? ProgressStyle::Quiet : options_.progress;
    }

    LoadedScene load() {
        return readScene(options_.scene, options_.settings, options_.device,
                         [&](const std::string& what, double done) {
                             throwIfInterrupted();
                             progress_->step(what, done);
                         });
    }

    RenderResult render(Renderer& renderer, const RenderJob& job) {
        try {
            return renderer.render(job, callbacks());
        } catch (const SettingError& error) {
            if (error.setting() != "denoise" || options_.settings.has("denoise"))
                throw;
            throw SettingError("denoise", error.problem() +
                                              "; the scene asks for it, and --denoise "
                                              "off renders without");
        }
    }

    RenderCallbacks callbacks() {
        RenderCallbacks callbacks;
        callbacks.onProgress = [&](const std::string& what, double done) {
            if (what != "rendering") // which onSamples shows
                progress_->step(what, done);
        };
        callbacks.onPrepared = [&] { deadline_.reset(); };
        callbacks.onSamples = [&](const RenderPlan& plan, const RenderTotals& totals) {
            if (isSampling_)
                return progress_->rendering(totals);
            isSampling_ = true;
            progress_.emplace(style(), plan);
        };
        callbacks.shouldStop = isInterrupted;
        callbacks.onWarning = [&](const std::string& warning) {
            progress_->clear();
            printWarning(warning);
        };
        return callbacks;
    }

    RenderOptions options_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::optional<InterruptDeadline> deadline_; ///< until a file may be written
    std::optional<Progress> progress_;
    bool isSampling_ = false;
};

} // namespace

int renderCommand(const RenderOptions& options) {
    catchInterrupts();
    return RenderRun(options).run();
}

} // namespace calotype
