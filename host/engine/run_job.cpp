#include "engine/run_job.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/output_failures.h"
#include "base/stopwatch.h"
#include "engine/denoised_goal.h"
#include "engine/denoising_memory.h"
#include "engine/film_keeper.h"
#include "engine/film_label.h"
#include "engine/loss_warnings.h"
#include "engine/make_session.h"
#include "engine/picture_denoiser.h"
#include "engine/picture_writer.h"
#include "engine/preview_denoiser.h"
#include "engine/render_engine.h"
#include "engine/scene_settings.h"
#include "engine/spare_file.h"
#include "engine/statistics.h"
#include "image/layers.h"
#include "render/render_session.h"
#include "settings/limits.h"

namespace calotype {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<float> floatsOf(const Image& image) {
    std::vector<float> floats;
    floats.reserve(3 * image.pixels.size());
    for (const glm::vec3& pixel : image.pixels)
        floats.insert(floats.end(), {pixel.r, pixel.g, pixel.b});
    return floats;
}

class JobRun {
public:
    JobRun(const Scene& scene, DeviceKeeper& device, const RenderJob& job,
           const RenderCallbacks& callbacks)
        : scene_(scene), device_(device), job_(job), callbacks_(callbacks), settings_(job.settings),
          start_(job.start.value_or(Clock::now())) {
        seconds_.load = job.loadSeconds;
        // Films always use the same kind of tree, so that parts of one film agree where surfaces
        // coincide.
        if (job.film.keepsFilm())
            settings_.bvh = settings_.bvh.value_or(BvhBuilder::Sah);
        Crop& crop = settings_.crop;
        if (crop.x == 0 && crop.y == 0 && crop.width == 0 && crop.height == 0)
            crop = {0, 0, settings_.width, settings_.height};
    }

    RenderResult run() {
        requireRenderable(settings_, device_.options());
        requireConsistent(job_);
        result_.warnings = scene_.warnings;
        const std::vector<std::filesystem::path> folders = outputFolders();
        std::optional<PictureDenoiser> denoiser;
        if (settings_.denoiser != DenoiserKind::Off)
            denoiser.emplace(settings_.denoiser, device_.options().denoiserLibrary, &device_);
        FilmKeeper keeper(job_.film, labelOf(scene_, settings_), settings_.crop,
                          detailFor(settings_.denoiser), folders,
                          [&](const std::string& warning) { warn(warning); });
        if (needsCleanPicture())
            requireDenoisingMemory(settings_, keeper.blocksToContinue() + blocksToRender());
        const LayerList& layers = job_.output.layers;
        const bool wantsHits = hasSource(layers, LayerSource::FirstHit);
        const bool wantsFeatures = (denoiser && !keeper.features()) ||
                                   hasSource(layers, LayerSource::Averaged) ||
                                   hasSource(layers, LayerSource::Mattes);
        const auto onStep = [&](const std::string& what, double done) { prepare(what, done); };
        const std::unique_ptr<RenderEngine> engine =
            makeEngine(device_, scene_, {settings_, wantsHits, wantsFeatures, onStep}, seconds_);
        throwIfStopped();
        if (settings_.targetError && engine->maxRadiance() == 0.0)
            throw SettingError("target_error", "has nothing to aim at: the scene has no light");
        FirstHitImage hits;
        if (wantsHits)
            hits = engine->firstHits([&](double done) { prepare("finding first hits", done); });
        FeatureImage features;
        Mattes mattes(scene_, layers, size_t{settings_.crop.width} * settings_.crop.height);
        if (wantsFeatures)
            features = timed(seconds_.features, [&] { return findFeatures(*engine, mattes); });
        if (denoiser && !keeper.features())
            keeper.setFeatures(denoiserFeatures(features));
        if (!hasSource(layers, LayerSource::Averaged)) // 32 bytes per pixel
            features = {};
        const PictureWriter writer(job_.output, keeper.label(), hits, features, mattes, folders);
        if (callbacks_.onPrepared)
            callbacks_.onPrepared();
        const std::unique_ptr<Session> session = begin(*engine, keeper);
        const double prepared = secondsSince(start_);
        result_.plan = planFor(*session);
        std::optional<DenoisedGoal> denoisedGoal;
        if (denoiser && settings_.targetError)
            denoisedGoal.emplace(*settings_.targetError, [&](const FilmView& film) {
                return clean(*denoiser, film, film.picture(), keeper.features());
            });
        PreviewDenoiser previewDenoiser(denoiser ? &*denoiser : nullptr, keeper.features(),
                                        device_.options().threads);
        result_.ending = render(*session, keeper, denoisedGoal, [&](double interval) {
            writePreview(writer, *session, previewDenoiser, interval);
        });
        session->error(); // of the final film, for the totals
        result_.totals = session->totals();
        seconds_.render = result_.totals.seconds;
        seconds_.firstSample = prepared + result_.totals.firstSampleSeconds;
        OutputFailures failures;
        if (keeper.isWanted()) // before anything that takes long, or may fail
            failures.attempt([&] { keeper.save(*film_); });
        std::exception_ptr denoiserFailure;
        if (denoiser && needsCleanPicture() && session->totals().samplesPerPixel > 0)
            denoiserFailure = denoisePicture(*denoiser, denoisedGoal, *session, keeper.features());
        const DisplayTransform display = takePixels(*session);
        writeAll(*session, *engine, writer, display, failures);
        engine->finish();
        for (const std::string& warning :
             lossWarnings(result_.totals.losses, engine->cutPixels(), engine->cutFeatureRays()))
            warn(warning);
        if (denoiserFailure) // after all that was rendered is written, without denoising
            std::rethrow_exception(denoiserFailure);
        return std::move(result_);
    }

private:
    /// Whether anything shows the picture or its error. A film alone is denoised later, where it is
    /// whole.
    bool needsCleanPicture() const {
        return !job_.output.pictures.empty() || !job_.output.statsFile.empty() ||
               job_.returnsPixels || settings_.targetError;
    }

    /// At most.
    uint64_t blocksToRender() const {
        const uint64_t samples =
            job_.limitsSamples ? settings_.samplesPerPixel : kMostSamplesPerPixel;
        return (samples + shared::kSamplesPerBlock - 1) / shared::kSamplesPerBlock;
    }

    bool isStopped() const { return callbacks_.shouldStop && callbacks_.shouldStop(); }

    void throwIfStopped() const {
        if (isStopped())
            throw Interrupted();
    }

    void report(const std::string& what, double done) const {
        if (callbacks_.onProgress)
            callbacks_.onProgress(what, done);
    }

    /// Reports a step before sampling. A stop there ends the render without a picture.
    void prepare(const std::string& what, double done) const {
        throwIfStopped();
        report(what, done);
    }

    FeatureImage findFeatures(RenderEngine& engine, Mattes& mattes) const {
        OnPrimitives onPrimitives;
        if (mattes.areWanted())
            onPrimitives = [&](std::span<const uint32_t> ray) { mattes.addRay(ray); };
        return engine.features([&](double done) { prepare("finding features", done); },
                               onPrimitives);
    }

    /// Each warning once: a checkpoint or preview that fails may do so every time.
    void warn(const std::string& warning) {
        if (std::ranges::find(result_.warnings, warning) != result_.warnings.end())
            return;
        result_.warnings.push_back(warning);
        if (callbacks_.onWarning)
            callbacks_.onWarning(warning);
    }

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
        plan.targetsDenoised = settings_.denoiser != DenoiserKind::Off;
        if (settings_.seconds)
            plan.seconds = std::max(0.0, *settings_.seconds - secondsSince(start_));
        if (job_.limitsSamples)
            plan.samplesPerPixel = session.samplesInTheEnd();
        return plan;
    }

    /// `writePreview` takes the seconds since the preview before.
    RenderEnding render(Session& session, FilmKeeper& keeper,
                        std::optional<DenoisedGoal>& denoisedGoal,
                        const std::function<void(double)>& writePreview) {
        const Clock::time_point start = Clock::now();
        const RenderPlan& plan = result_.plan;
        RenderGoal goal;
        goal.targetError = plan.targetError;
        if (denoisedGoal)
            goal.denoisedError = [&](const FilmView& film) { return denoisedGoal->errorOf(film); };
        if (plan.seconds)
            goal.deadline = start + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(*plan.seconds));
        if (callbacks_.onSamples)
            callbacks_.onSamples(plan, session.totals());
        const PreviewInterval& interval = job_.output.previewInterval;
        Clock::time_point lastPreview = start;
        const auto preview = [&] {
            writePreview(secondsSince(lastPreview));
            lastPreview = Clock::now();
        };
        RenderObserver observer;
        observer.shouldStop = [&] {
            return isStopped() || (denoisedGoal && denoisedGoal->failure());
        };
        observer.onDispatch = [&](const RenderTotals& totals) {
            if (callbacks_.onSamples)
                callbacks_.onSamples(plan, totals);
            report("rendering", shareDone(plan, totals, secondsSince(start)));
            if (interval.seconds > 0.0 && secondsSince(lastPreview) >= interval.seconds)
                preview();
        };
        uint64_t previews = 0;
        observer.onPass = [&](const RenderTotals& totals) {
            if (interval.samples == 0 || totals.samplesPerPixel / interval.samples <= previews)
                return;
            previews = totals.samplesPerPixel / interval.samples;
            preview();
        };
        if (keeper.isWanted())
            observer.onBlock = [&] { keeper.checkpoint(*film_); };
        return session.run(observer, interval.samples, goal);
    }

    /// A preview that cannot be denoised, or not be written, does not end the render.
    void writePreview(const PictureWriter& writer, Session& session, PreviewDenoiser& denoiser,
                      double interval) {
        std::optional<CleanPicture> clean;
        try {
            clean = denoiser.run(session.picture(), interval);
        } catch (const std::exception& error) {
            warn("a preview is not denoised: " + std::string(error.what()));
        }
        try {
            writer.writePreview(session, clean);
        } catch (const OutputError& error) {
            warn(error.what());
        }
    }

    /// A step of denoising. Throws Interrupted at a stop.
    void reportDenoising(double done) const {
        if (done < 1.0)
            throwIfStopped();
        report("denoising", done);
    }

    /// `noisy` as for PictureDenoiser::run. Throws Interrupted at a stop.
    CleanPicture clean(const PictureDenoiser& denoiser, const FilmView& film, const Image& noisy,
                       const std::optional<DenoiserFeatures>& features) const {
        return denoiser.run(film, noisy, features, device_.options().threads,
                            [&](double done) { reportDenoising(done); });
    }

    /// Denoises the picture, unless the render is stopped: denoising takes long. Returns why it
    /// failed, if it did.
    std::exception_ptr denoisePicture(const PictureDenoiser& denoiser,
                                      std::optional<DenoisedGoal>& goal, Session& session,
                                      const std::optional<DenoiserFeatures>& features) {
        seconds_.denoise = goal ? goal->seconds() : 0.0;
        if (goal && goal->failure())
            return goal->failure();
        const Clock::time_point before = Clock::now();
        try {
            if (result_.ending == RenderEnding::Stopped)
                throw Interrupted();
            const FilmView film = session.filmView();
            const std::string why = denoiser.whyTooFewSamples(film);
            if (!why.empty()) {
                warn("the picture is not denoised: " + why);
                return nullptr;
            }
            if (callbacks_.onSamples)
                callbacks_.onSamples(result_.plan, result_.totals);
            reportDenoising(0.0);
            if (goal)
                clean_ = goal->take(film);
            if (!clean_)
                clean_ = clean(denoiser, film, session.picture(), features);
        } catch (const Interrupted&) {
            result_.ending = RenderEnding::Stopped;
            warn("the picture is not denoised, because the render was stopped");
            return nullptr;
        } catch (const std::exception&) {
            return std::current_exception();
        }
        seconds_.denoise += secondsSince(before);
        result_.isDenoised = true;
        result_.denoised = clean_->error;
        result_.whyUnstated = clean_->whyUnstated;
        return nullptr;
    }

    /// If one of the outputs fails, the others are still written.
    void writeAll(Session& session, const RenderEngine& engine, const PictureWriter& writer,
                  const DisplayTransform& display, OutputFailures& failures) {
        const Clock::time_point before = Clock::now();
        failures.attempt([&] { writer.writeOutputs(session, clean_, display); });
        seconds_.write = secondsSince(before);
        if (!job_.output.statsFile.empty())
            failures.attempt([&] {
                writeFileAtomically(
                    job_.output.statsFile,
                    toJson({engine.info(), settings_, scene_.hash, result_.totals, result_.denoised,
                            result_.ending, seconds_, engine.deviceBytes(), engine.tree()}));
            });
        failures.throwIfAny();
    }

    std::vector<std::filesystem::path> outputFolders() const {
        std::vector<std::string> files = job_.output.pictures;
        files.push_back(job_.film.path());
        return foldersOf(files);
    }

    /// Returns how PNGs show the picture.
    DisplayTransform takePixels(Session& session) {
        result_.width = settings_.crop.width;
        result_.height = settings_.crop.height;
        const DisplayTransform& wanted = job_.output.display;
        if (!job_.returnsPixels && wanted.exposureStops)
            return wanted;
        const Image picture = clean_ ? clean_->color : session.picture();
        if (job_.returnsPixels) {
            result_.pixels = floatsOf(picture);
            result_.alpha = session.alpha();
        }
        const DisplayTransform display = withExposureOf(picture, wanted);
        if (!wanted.exposureStops)
            result_.exposureStops = display.exposureStops;
        return display;
    }

    const Scene& scene_;
    DeviceKeeper& device_;
    const RenderJob& job_;
    const RenderCallbacks& callbacks_;
    RenderSettings settings_;
    Clock::time_point start_;
    StageSeconds seconds_;
    RenderResult result_;
    std::optional<CleanPicture> clean_; ///< the picture after denoising
    const Film* film_ = nullptr;        ///< of the session, if a film may be written
};

} // namespace

RenderResult runJob(const Scene& scene, DeviceKeeper& device, const RenderJob& job,
                    const RenderCallbacks& callbacks) {
    return JobRun(scene, device, job, callbacks).run();
}

} // namespace calotype
