#include "engine/render_job.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "engine/film_label.h"
#include "engine/make_session.h"
#include "engine/picture_writer.h"
#include "engine/render_engine.h"
#include "engine/scene_settings.h"
#include "engine/statistics.h"
#include "film/develop.h"
#include "render/render_session.h"

namespace calotype {
namespace {

using Clock = std::chrono::steady_clock;

class JobRun {
public:
    JobRun(Scene scene, const RenderJob& job, const RenderJobObserver& observer)
        : scene_(std::move(scene)), job_(job), observer_(observer), settings_(job.settings) {
        seconds_.load = job.loadSeconds;
        // Films always use the same kind of tree, so that parts of one film agree where surfaces
        // coincide.
        if (job.film.keepsFilm())
            settings_.bvh = settings_.bvh.value_or(BvhBuilder::Sah);
    }

    RenderOutcome run() {
        requireRenderable(settings_, job_.device);
        const TextureFilterOverride filters(scene_, settings_.textureFilter);
        FilmKeeper keeper(job_.film, labelOf(scene_, settings_), settings_.crop,
                          observer_.onWarning);
        const bool wantsHits =
            hasSource(neededLayers(job_.output.layers, job_.output.stages), LayerSource::FirstHit);
        const std::unique_ptr<RenderEngine> engine =
            makeEngine(job_.device, scene_, {settings_, wantsHits, observer_.onStep}, seconds_);
        if (observer_.shouldStop())
            throw Interrupted();
        if (settings_.targetError && engine->maxRadiance() == 0.0)
            throw SettingError("target_error", "has nothing to aim at: the scene has no light");
        FirstHitImage hits;
        if (wantsHits)
            hits = engine->firstHits(
                [&](double done) { observer_.onStep("finding first hits", done); });
        const PictureWriter writer(job_.output, keeper.label(), std::move(hits));
        const std::unique_ptr<Session> session = begin(*engine, keeper);
        const double prepared = secondsSince(job_.start);
        RenderOutcome outcome;
        outcome.plan = planFor(*session);
        outcome.ending = render(*session, outcome.plan, keeper, writer);
        session->error(); // of the final film, for the totals
        outcome.totals = session->totals();
        outcome.cutPixels = engine->cutPixels();
        seconds_.render = outcome.totals.seconds;
        seconds_.firstSample = prepared + outcome.totals.firstSampleSeconds;
        writeAll(*session, keeper, writer);
        if (!job_.output.statsFile.empty())
            writeFileAtomically(
                job_.output.statsFile,
                toJson({engine->info(), settings_, scene_.hash, outcome.totals, outcome.ending,
                        seconds_, engine->deviceBytes(), engine->tree()}));
        engine->finish();
        return outcome;
    }

private:
    /// Starts with the film of the keeper, if one is written.
    std::unique_ptr<Session> begin(RenderEngine& engine, FilmKeeper& keeper) {
        if (settings_.isAdaptive)
            return makeSession(engine.tracer(), settings_, engine.maxRadiance());
        auto session = std::make_unique<RenderSession>(
            engine.tracer(), settings_,
            keeper.begin(settings_, engine.maxRadiance(), engine.info()));
        film_ = &session->film();
        return session;
    }

    RenderPlan planFor(const Session& session) const {
        RenderPlan plan;
        plan.pixels = uint64_t{settings_.crop.width} * settings_.crop.height;
        plan.samplesBefore = session.totals().samplesPerPixel;
        plan.targetError = settings_.targetError;
        if (settings_.seconds)
            plan.seconds = std::max(0.0, *settings_.seconds - secondsSince(job_.start));
        if (job_.limitsSamples)
            plan.samplesPerPixel = session.samplesInTheEnd();
        return plan;
    }

    RenderEnding render(Session& session, const RenderPlan& plan, FilmKeeper& keeper,
                        const PictureWriter& writer) {
        RenderGoal goal;
        goal.targetError = settings_.targetError;
        if (plan.seconds)
            goal.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                               std::chrono::duration<double>(*plan.seconds));
        observer_.onStart(plan);
        const PreviewInterval& interval = job_.output.previewInterval;
        Clock::time_point lastPreview = Clock::now();
        RenderObserver observer;
        observer.shouldStop = observer_.shouldStop;
        observer.onDispatch = [&](const RenderTotals& totals) {
            observer_.onDispatch(totals);
            if (interval.seconds > 0.0 && secondsSince(lastPreview) >= interval.seconds) {
                writePreview(writer, session);
                lastPreview = Clock::now();
            }
        };
        uint64_t previews = 0;
        observer.onPass = [&](const RenderTotals& totals) {
            if (interval.samples == 0 || totals.samplesPerPixel / interval.samples <= previews)
                return;
            previews = totals.samplesPerPixel / interval.samples;
            writePreview(writer, session);
        };
        if (keeper.isWanted())
            observer.onBlock = [&] { keeper.checkpoint(*film_); };
        return session.run(observer, interval.samples, goal);
    }

    /// A preview that cannot be written does not end the render.
    void writePreview(const PictureWriter& writer, Session& session) const {
        try {
            writer.writePreview(session);
        } catch (const OutputError& error) {
            observer_.onWarning(error.what());
        }
    }

    /// If one of the outputs fails, the others are still written.
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

    Scene scene_;
    const RenderJob& job_;
    const RenderJobObserver& observer_;
    RenderSettings settings_;
    StageSeconds seconds_;
    const Film* film_ = nullptr; ///< of the session, if a film may be written
};

} // namespace

RenderOutcome runRenderJob(Scene scene, const RenderJob& job, const RenderJobObserver& observer) {
    return JobRun(std::move(scene), job, observer).run();
}

} // namespace calotype
