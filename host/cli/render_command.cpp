#include "cli/commands.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>

#include "base/atomic_file.h"
#include "base/error.h"
#include "cli/check_outputs.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/render_engine.h"
#include "cli/statistics.h"
#include "cli/timed.h"
#include "film/write_image.h"
#include "render/render_session.h"
#include "scene/load.h"

namespace calotype {
namespace {

using Clock = std::chrono::steady_clock;

void throwIfInterrupted() {
    if (isInterrupted())
        throw Interrupted();
}

/// Shows what is being done, and the share of it done.
void step(Progress& progress, const std::string& what, double done) {
    throwIfInterrupted();
    progress.step(what, done);
}

RenderSettings makeSettings(const RenderOptions& options, const Scene& scene) {
    RenderSettings settings;
    settings.width = scene.film.width;
    settings.height = scene.film.height;
    settings.crop = options.crop.value_or(Crop{0, 0, settings.width, settings.height});
    const Crop& crop = settings.crop;
    if (crop.x >= settings.width || crop.width > settings.width - crop.x ||
        crop.y >= settings.height || crop.height > settings.height - crop.y)
        throw UsageError("--crop reaches beyond the picture of " + std::to_string(settings.width) +
                         "x" + std::to_string(settings.height) + " pixels");
    settings.samplesPerPixel = options.samplesPerPixel.value_or(scene.render.samplesPerPixel);
    settings.maxBounces = options.maxBounces.value_or(scene.render.maxBounces);
    settings.seed = options.seed.value_or(scene.render.seed);
    settings.sampler = options.sampler;
    return settings;
}

/// One `calotype render`, stage by stage.
class RenderRun {
public:
    explicit RenderRun(const RenderOptions& options) : options_(options) {}

    int run() {
        checkOutputs(options_);
        Progress preparation(options_.quiet);
        const Scene scene = timed(seconds_.load, [&] { return load(preparation); });
        preparation.clear();
        for (const std::string& warning : scene.warnings)
            std::fprintf(stderr, "calotype: warning: %s\n", warning.c_str());
        settings_ = makeSettings(options_, scene);
        sceneHash_ = scene.hash;
        const std::unique_ptr<RenderEngine> engine = makeEngine(
            options_.device, scene,
            {settings_, wantsLayers(), options_.bvh, false,
             [&](const std::string& what, double done) { step(preparation, what, done); }},
            seconds_);
        throwIfInterrupted();
        if (wantsLayers())
            firstHits_ = engine->firstHits(
                [&](double done) { step(preparation, "finding first hits", done); });
        cutPixels_ = engine->cutPixels();
        preparation.clear();
        const double prepared = std::chrono::duration<double>(Clock::now() - start_).count();
        RenderSession session(engine->tracer(), settings_, engine->maxRadiance());
        const bool complete = render(session);
        totals_ = session.totals();
        seconds_.render = totals_.seconds;
        seconds_.firstSample = prepared + totals_.firstSampleSeconds;
        timed(seconds_.write, [&] { return writeOutputs(session.picture()); });
        if (!options_.statsFile.empty())
            writeFileAtomically(options_.statsFile,
                                toJson({engine->info(), settings_, totals_, seconds_,
                                        engine->deviceBytes(), sceneHash_}));
        engine->finish();
        report(complete);
        return complete ? kExitDone : kExitOther;
    }

private:
    Scene load(Progress& progress) {
        LoadOptions loadOptions;
        loadOptions.overrides = options_.scene.overrides;
        loadOptions.missingTextures = options_.scene.missingTextures;
        loadOptions.size = options_.size;
        loadOptions.onProgress = [&](const std::string& what, double done) {
            step(progress, "loading " + what, done);
        };
        Scene scene = loadScene(options_.scene.path, loadOptions);
        throwIfInterrupted();
        return scene;
    }

    bool wantsLayers() const { return !options_.layers.empty(); }

    bool render(RenderSession& session) {
        const uint64_t pixels = uint64_t{settings_.crop.width} * settings_.crop.height;
        Progress progress(options_.quiet, pixels * settings_.samplesPerPixel,
                          settings_.samplesPerPixel);
        const PreviewInterval& interval = options_.previewInterval;
        Clock::time_point lastPreview = Clock::now();
        RenderObserver observer;
        observer.shouldStop = isInterrupted;
        observer.onDispatch = [&](const RenderTotals& totals) {
            progress.rendering(totals);
            const double sincePreview =
                std::chrono::duration<double>(Clock::now() - lastPreview).count();
            if (interval.seconds > 0.0 && sincePreview >= interval.seconds) {
                writePreview(session);
                lastPreview = Clock::now();
            }
        };
        observer.onPass = [&](const RenderTotals& totals) {
            if (interval.samples > 0 && totals.samplesPerPixel % interval.samples == 0)
                writePreview(session);
        };
        return session.run(observer, interval.samples);
    }

    void writePreview(RenderSession& session) {
        totals_ = session.totals();
        try {
            write(options_.previewFile.empty() ? options_.outputs.front() : options_.previewFile,
                  session.picture());
        } catch (const OutputError& error) { // the render is worth more than a preview of it
            std::fprintf(stderr, "calotype: warning: %s\n", error.what());
        }
    }

    /// Writes every output that can be written, then throws what went wrong first, if anything.
    bool writeOutputs(const Image& picture) {
        std::exception_ptr firstError;
        for (const std::string& path : options_.outputs) {
            try {
                write(path, picture);
            } catch (const OutputError&) {
                firstError = firstError ? firstError : std::current_exception();
            }
        }
        if (firstError)
            std::rethrow_exception(firstError);
        return true;
    }

    void write(const std::string& path, const Image& picture) const {
        ExrMetadata metadata;
        metadata.version = CALOTYPE_VERSION;
        metadata.sceneHash = sceneHash_;
        metadata.seed = settings_.seed;
        metadata.sampler = nameOf(settings_.sampler);
        metadata.samplesPerPixel = totals_.samplesPerPixel;
        metadata.seconds = totals_.seconds;
        const Crop& crop = settings_.crop;
        metadata.crop = CropPlacement{crop.x, crop.y, settings_.width, settings_.height};
        const ExrLayers layers{wantsLayers() ? &firstHits_ : nullptr, options_.layers};
        writeImage(path, picture, options_.display, metadata, layers);
    }

    void report(bool complete) const {
        const auto warn = [](uint64_t count, const char* text) {
            if (count > 0)
                std::fprintf(stderr, "calotype: warning: %llu %s\n",
                             static_cast<unsigned long long>(count), text);
        };
        warn(totals_.nonFiniteSamples, "samples were not finite and count as black");
        warn(totals_.cutPaths,
             "paths were cut short by the device's loop limit, so the picture is "
             "too dark; lower --max-bounces, use fewer transparent layers, or take a GPU");
        warn(cutPixels_, "pixels lie behind more transparent surfaces than the layers of --aov see "
                         "through, and show one of those as if it were opaque");
        warn(totals_.lostBlocks,
             "blocks of samples were too bright for the film and count as black");
        const std::string samples = std::to_string(totals_.samplesPerPixel) + " of " +
                                    std::to_string(settings_.samplesPerPixel) +
                                    " samples per pixel";
        if (!complete)
            std::fprintf(stderr, "calotype: interrupted after %s; the picture so far is in %s\n",
                         samples.c_str(), options_.outputs.front().c_str());
        else if (!options_.quiet)
            std::fprintf(stderr, "%s: %s in %s, %s samples/s, %s rays/s\n",
                         options_.outputs.front().c_str(), samples.c_str(),
                         durationText(totals_.seconds).c_str(),
                         withPrefix(static_cast<double>(totals_.paths) / totals_.seconds).c_str(),
                         withPrefix(static_cast<double>(totals_.rays) / totals_.seconds).c_str());
    }

    const RenderOptions& options_;
    const Clock::time_point start_ = Clock::now();
    RenderSettings settings_;
    RenderTotals totals_;
    StageSeconds seconds_;
    uint64_t sceneHash_ = 0;
    FirstHitImage firstHits_; ///< empty where no layer is wanted
    uint64_t cutPixels_ = 0;  ///< of firstHits_
};

} // namespace

int renderCommand(const RenderOptions& options) {
    catchInterrupts();
    return RenderRun(options).run();
}

} // namespace calotype
