#include "cli/commands.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "cli/check_outputs.h"
#include "cli/device_session.h"
#include "cli/exit_code.h"
#include "cli/film_keeper.h"
#include "cli/interrupt.h"
#include "cli/picture_writer.h"
#include "cli/progress.h"
#include "cli/read_scene.h"
#include "cli/render_engine.h"
#include "cli/render_report.h"
#include "cli/statistics.h"
#include "cli/timed.h"
#include "film/develop.h"
#include "render/adaptive_session.h"
#include "render/render_session.h"
#include "settings/limits.h"

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
    RenderSettings settings = settingsOf(scene);
    settings.crop = options.crop.value_or(settings.crop);
    const Crop& crop = settings.crop;
    if (crop.x >= settings.width || crop.width > settings.width - crop.x ||
        crop.y >= settings.height || crop.height > settings.height - crop.y)
        throw UsageError("--crop reaches beyond the picture of " + std::to_string(settings.width) +
                         "x" + std::to_string(settings.height) + " pixels");
    // An error or a time that is wished for is not to be cut short by the scene's number of
    // samples.
    const bool hasGoal = options.targetError || options.seconds;
    settings.samplesPerPixel =
        options.samplesPerPixel.value_or(hasGoal ? kMostSamplesPerPixel : settings.samplesPerPixel);
    if (options.samples) {
        settings.firstSample = options.samples->begin;
        settings.samplesPerPixel = options.samples->end - options.samples->begin;
    }
    settings.maxBounces = options.maxBounces.value_or(settings.maxBounces);
    settings.seed = options.seed.value_or(settings.seed);
    settings.sampler = options.sampler;
    settings.transport = options.transport;
    return settings;
}

/// Films take one kind of tree whatever the number of samples, lest parts of one film differ where
/// surfaces touch.
std::optional<BvhBuilder> builderFor(const RenderOptions& options) {
    const bool keepsFilm = !options.film.film.empty() || !options.film.resume.empty();
    return keepsFilm ? options.bvh.value_or(BvhBuilder::Sah) : options.bvh;
}

/// One `calotype render`, stage by stage.
class RenderRun {
public:
    explicit RenderRun(const RenderOptions& options) : options_(options) {}

    int run() {
        checkOutputs(options_);
        if (options_.lightChoice == LightChoice::All && !isReference(options_.device))
            throw UsageError(
                "--light-choice all is the reference tracer's; add --device reference");
        Progress preparation(options_.quiet);
        const Scene scene = timed(seconds_.load, [&] { return load(preparation); });
        preparation.clear();
        printWarnings(scene);
        const RenderSettings settings = makeSettings(options_, scene);
        FilmKeeper keeper(options_.film,
                          labelOf(scene, settings, builderFor(options_), options_.textureFilter),
                          settings.crop);
        const bool wantsHits =
            hasSource(neededLayers(options_.layers, options_.stages), LayerSource::FirstHit);
        const std::unique_ptr<RenderEngine> engine = makeEngine(
            options_.device, scene,
            {settings, wantsHits, builderFor(options_), false,
             [&](const std::string& what, double done) { step(preparation, what, done); }},
            seconds_);
        throwIfInterrupted();
        if (options_.targetError && engine->maxRadiance() == 0.0)
            throw UsageError("--target-error has nothing to aim at: the scene has no light");
        FirstHitImage hits;
        if (wantsHits)
            hits = engine->firstHits(
                [&](double done) { step(preparation, "finding first hits", done); });
        const PictureWriter writer(options_, keeper.label(), std::move(hits));
        preparation.clear();
        const std::unique_ptr<Session> session = begin(*engine, settings, keeper);
        const double prepared = secondsSince(start_);
        const RenderPlan plan = planFor(*session, settings);
        const RenderEnding ending = render(*session, plan, keeper, writer);
        session->error(); // of the film as it ended, for the totals
        const RenderTotals& totals = session->totals();
        seconds_.render = totals.seconds;
        seconds_.firstSample = prepared + totals.firstSampleSeconds;
        writeAll(*session, keeper, writer);
        if (!options_.statsFile.empty())
            writeFileAtomically(
                options_.statsFile,
                toJson({engine->info(), settings, totals, ending, seconds_, engine->deviceBytes(),
                        keeper.label(), engine->tree(), options_.adapts}));
        engine->finish();
        reportRender(
            {options_, totals, ending, plan.samplesPerPixel, keeper.path(), engine->cutPixels()});
        return ending == RenderEnding::Stopped ? kExitOther : kExitDone;
    }

private:
    Scene load(Progress& progress) {
        Scene scene =
            readScene(options_.scene, options_.size,
                      [&](const std::string& what, double done) { step(progress, what, done); });
        scene.lightChoice = options_.lightChoice;
        if (options_.textureFilter)
            for (Texture& texture : scene.textures)
                if (auto* image = std::get_if<ImageTexture>(&texture.source))
                    image->filter = *options_.textureFilter;
        throwIfInterrupted();
        return scene;
    }

    /// With the film that the keeper has, if one is kept.
    std::unique_ptr<Session> begin(RenderEngine& engine, const RenderSettings& settings,
                                   FilmKeeper& keeper) {
        if (options_.adapts)
            return std::make_unique<AdaptiveSession>(engine.tracer(), settings,
                                                     engine.maxRadiance());
        auto session = std::make_unique<RenderSession>(
            engine.tracer(), settings, keeper.begin(settings, engine.maxRadiance(), engine.info()));
        film_ = &session->film();
        return session;
    }

    RenderPlan planFor(const Session& session, const RenderSettings& settings) const {
        RenderPlan plan;
        plan.pixels = uint64_t{settings.crop.width} * settings.crop.height;
        plan.samplesBefore = session.totals().samplesPerPixel;
        plan.targetError = options_.targetError;
        if (options_.seconds)
            plan.seconds = std::max(0.0, *options_.seconds - secondsSince(start_));
        if (options_.samplesPerPixel || options_.samples ||
            !(options_.targetError || options_.seconds))
            plan.samplesPerPixel = session.samplesInTheEnd();
        return plan;
    }

    RenderEnding render(Session& session, const RenderPlan& plan, FilmKeeper& keeper,
                        const PictureWriter& writer) {
        RenderGoal goal;
        goal.targetError = options_.targetError;
        if (plan.seconds)
            goal.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                               std::chrono::duration<double>(*plan.seconds));
        Progress progress(options_.quiet, plan);
        const PreviewInterval& interval = options_.previewInterval;
        Clock::time_point lastPreview = Clock::now();
        RenderObserver observer;
        observer.shouldStop = isInterrupted;
        observer.onDispatch = [&](const RenderTotals& totals) {
            progress.rendering(totals);
            if (interval.seconds > 0.0 && secondsSince(lastPreview) >= interval.seconds) {
                writer.writePreview(session);
                lastPreview = Clock::now();
            }
        };
        uint64_t previews = 0;
        observer.onPass = [&](const RenderTotals& totals) {
            if (interval.samples == 0 || totals.samplesPerPixel / interval.samples <= previews)
                return;
            previews = totals.samplesPerPixel / interval.samples;
            writer.writePreview(session);
        };
        if (keeper.isWanted())
            observer.onBlock = [&] { keeper.checkpoint(*film_); };
        return session.run(observer, interval.samples, goal);
    }

    /// Where one of the outputs fails, the others are written all the same.
    void writeAll(Session& session, FilmKeeper& keeper, const PictureWriter& writer) {
        const Clock::time_point before = Clock::now();
        std::exception_ptr filmError;
        try {
            if (keeper.isWanted())
                keeper.save(*film_);
        } catch (const OutputError&) {
            filmError = std::current_exception();
        }
        writer.writeOutputs(session);
        if (filmError)
            std::rethrow_exception(filmError);
        seconds_.write = secondsSince(before);
    }

    const RenderOptions& options_;
    const Clock::time_point start_ = Clock::now();
    StageSeconds seconds_;
    const Film* film_ = nullptr; ///< of the session, if it keeps one
};

} // namespace

int renderCommand(const RenderOptions& options) {
    catchInterrupts();
    return RenderRun(options).run();
}

} // namespace calotype
