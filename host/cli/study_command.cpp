#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/names.h"
#include "base/number_text.h"
#include "base/output_failures.h"
#include "base/stopwatch.h"
#include "cli/commands.h"
#include "cli/device_environment.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/interrupt_deadline.h"
#include "cli/output_claims.h"
#include "cli/progress.h"
#include "cli/read_scene.h"
#include "engine/device_session.h"
#include "engine/devices.h"
#include "engine/picture_denoiser.h"
#include "engine/render_engine.h"
#include "engine/scene_settings.h"
#include "engine/spare_file.h"
#include "engine/stage_seconds.h"
#include "image/denoiser_features.h"
#include "settings/setting_kinds.h"
#include "study/advice.h"
#include "study/csv.h"
#include "study/json.h"
#include "study/page.h"
#include "study/plot.h"
#include "study/study.h"

namespace calotype {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kFiles[] = {"study.csv", "study.json", "study.svg", "study.html"};

/// Throws OutputError if the folder cannot be made.
std::filesystem::path makeFolder(const StudyOptions& options) {
    std::filesystem::path folder = options.folder;
    if (folder.empty())
        folder = "study-" + std::filesystem::path(options.scene.path).stem().string();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw OutputError("cannot make the folder '" + folder.string() + "': " + error.message());
    return folder;
}

/// Removes the folder if it is empty.
void cleanUp(const std::filesystem::path& folder) {
    std::error_code ignored; // such as: not empty
    std::filesystem::remove(folder, ignored);
}

/// Throws UsageError if the study would replace a file of the scene, and OutputError if a file
/// cannot be written.
OutputClaims claimFiles(const std::filesystem::path& folder, const LoadedScene& scene) {
    try {
        OutputClaims claims;
        claims.reserve(scene.files());
        for (const char* name : kFiles)
            claims.claim((folder / name).string());
        return claims;
    } catch (...) {
        cleanUp(folder);
        throw;
    }
}

/// The command that renders the scene of the study.
std::string renderCommandOf(const StudyOptions& options) {
    std::string command = "calotype render " + shellWord(options.scene.path);
    for (const SceneOverride& override : options.scene.overrides)
        command += " --set " + shellWord(override.pointer + "=" + override.value);
    const auto addPoint = [&](const char* name, const std::optional<glm::dvec3>& point) {
        if (point)
            command += std::string(" ") + name + " " + shortestText(point->x) + "," +
                       shortestText(point->y) + "," + shortestText(point->z);
    };
    const ViewOptions& view = options.scene.view;
    addPoint("--from", view.from);
    addPoint("--look-at", view.lookAt);
    addPoint("--up", view.up);
    if (view.fov)
        command += " --fov " + shortestText(*view.fov);
    if (options.scene.missingTextures == MissingTextures::Warn)
        command += " --missing-textures warn";
    if (const std::string settings = options.settings.options(); !settings.empty())
        command += " " + settings;
    if (!options.device.device.empty())
        command += " --device " + shellWord(options.device.device);
    if (options.device.threads > 0)
        command += " --threads " + std::to_string(options.device.threads);
    return command + " -o picture.exr";
}

/// `which`: of the error.
void printChoices(const std::vector<Choice>& choices, const std::string& which, const Study& study,
                  const std::string& command) {
    for (const Choice& choice : choices) {
        std::string text = targetText(choice.target) + " error" + which + ": ";
        if (choice.measurement) {
            const std::string& options = choice.options;
            text += (options.empty() ? "the default" : options) + ", " +
                    durationText(choice.seconds) + (choice.isExtrapolated ? " (extrapolated)" : "");
            if (study.scale > 1.0)
                text +=
                    ", at the scene's own size about " + durationText(choice.seconds * study.scale);
            if (!options.empty() && choice.usual)
                text += " (default settings: " + durationText(*choice.usual) + ")";
            text += "\n  " + commandOf(choice, command);
        } else {
            text += whyNone(choice);
        }
        std::printf("%s\n", text.c_str());
    }
}

/// The denoisers that can be used here.
void addDenoisers(const DeviceOptions& device, StudyPlan& plan) {
    for (const DenoiserKind kind : {DenoiserKind::Oidn, DenoiserKind::Statistical})
        try {
            PictureDenoiser(kind, device.denoiserLibrary);
            plan.denoisers.push_back(kind);
        } catch (const SettingError& error) {
            plan.omitted.push_back({std::string("denoised by ") + nameOf(kind), error.problem()});
        }
}

/// What a variant uses.
struct Prepared {
    explicit Prepared(const DeviceOptions& options) : device(options) {}

    DeviceKeeper device; ///< anew for each, so that none gets the kernels of another
    std::unique_ptr<RenderEngine> engine = nullptr;
    std::optional<PictureDenoiser> denoiser = std::nullopt;
    std::optional<DenoiserFeatures> features = std::nullopt;
};

PreparedTracer prepareTracer(const DeviceOptions& device, const Scene& scene,
                             const RenderSettings& settings,
                             const std::function<void(const std::string&, double)>& onStep,
                             std::string& deviceName) {
    const bool isDenoised = settings.denoiser != DenoiserKind::Off;
    StageSeconds seconds;
    const auto all = std::make_shared<Prepared>(device);
    all->engine = makeEngine(all->device, scene, {settings, false, isDenoised, onStep}, seconds);
    RenderEngine& engine = *all->engine;
    deviceName = engine.info().name;
    PreparedTracer prepared{all,           &engine.tracer(), engine.maxRadiance(),
                            seconds.build, seconds.compile,  [all] { all->engine->finish(); }};
    if (!isDenoised)
        return prepared;
    all->denoiser.emplace(settings.denoiser, device.denoiserLibrary, &all->device);
    all->features = timed(prepared.featureSeconds, [&] {
        return denoiserFeatures(
            engine.features([&](double done) { onStep("finding features", done); }, {}));
    });
    prepared.denoise = [all, threads = device.threads](const FilmView& film,
                                                       const auto& onProgress) {
        return all->denoiser->run(film, film.picture(), all->features, threads, onProgress);
    };
    return prepared;
}

/// Runs the study; if it fails, gives up the claims, and removes the folder if that is empty.
Study runOrClean(const std::filesystem::path& folder, std::optional<OutputClaims>& claims,
                 const std::function<Study()>& run) {
    try {
        Study study = run();
        if (study.measurements.empty())
            throw Error(
                "interrupted before the default settings were measured; nothing was written");
        return study;
    } catch (...) {
        claims.reset(); // whose files are in the folder
        cleanUp(folder);
        throw;
    }
}

/// If one of the files cannot be written, it is kept elsewhere, and the others are still written.
void writeAll(const Study& study, const StudyOrigin& origin, const std::filesystem::path& folder) {
    const std::string contents[] = {toCsv(study), toJson(study, origin), toSvg(study, origin.scene),
                                    toHtml(study, origin)};
    OutputFailures failures;
    for (size_t i = 0; i < std::size(kFiles); ++i)
        failures.attempt([&] {
            SpareFile(folder / kFiles[i], {}).write(kFiles[i], [&](const auto& path) {
                writeFileAtomically(path, contents[i]);
            });
        });
    failures.throwIfAny();
}

/// Reports what is missing from the study. Returns the exit code.
int reportGaps(const Study& study, const std::filesystem::path& folder) {
    for (const FailedVariant& failure : study.failures)
        std::fprintf(stderr, "calotype: warning: not measured: %s: %s\n", failure.name.c_str(),
                     failure.reason.c_str());
    for (const FailedVariant& variant : study.omitted)
        std::fprintf(stderr, "calotype: note: not measured: %s: %s\n", variant.name.c_str(),
                     variant.reason.c_str());
    if (study.ending == StudyEnding::OutOfTime)
        std::fprintf(stderr, "calotype: warning: --budget was too short for all settings\n");
    if (study.ending == StudyEnding::Stopped)
        std::fprintf(stderr, "calotype: interrupted; what was measured so far is in %s\n",
                     folder.string().c_str());
    const bool isDone = study.ending != StudyEnding::Stopped && study.failures.empty();
    return isDone ? kExitDone : kExitOther;
}

} // namespace

int studyCommand(const StudyOptions& options) {
    catchInterrupts();
    const DeviceOptions device = withEnvironment(options.device, true);
    const Clock::time_point start = Clock::now();
    Progress progress(options.quiet ? ProgressStyle::Quiet : ProgressStyle::Text);
    const auto show = [&](const std::string& what) {
        const double done = secondsSince(start) / options.budget;
        const double left = options.budget - secondsSince(start);
        progress.step(what + ", " + durationText(std::max(0.0, left)) + " left", done);
    };
    std::optional<InterruptDeadline> deadline(Interrupted().what());
    LoadedScene loaded =
        readScene(options.scene, options.settings, device, [&](const std::string& what, double) {
            throwIfInterrupted();
            show(what);
        });
    deadline.reset();
    progress.clear();
    const std::filesystem::path folder = makeFolder(options);
    std::optional<OutputClaims> claims = claimFiles(folder, loaded);
    deadline.emplace(Interrupted().what(), folder.string()); // until samples may be lost
    const Scene scene = std::move(loaded);
    printWarnings(scene);

    StudyOrigin origin;
    origin.scene = std::filesystem::path(options.scene.path).filename().string();
    origin.command = renderCommandOf(options);
    const auto onStep = [&](const std::string& what, double) {
        if (isInterrupted())
            throw StudyStopped();
        show(what);
    };
    const PrepareTracer prepare = [&](const RenderSettings& settings) {
        PreparedTracer prepared = prepareTracer(device, scene, settings, onStep, origin.device);
        deadline.reset();
        if (prepared.maxRadiance == 0.0)
            throw SceneError(options.scene.path, "the scene has no light, so no error to study");
        return prepared;
    };
    StudyObserver observer;
    observer.shouldStop = isInterrupted;
    observer.onProgress = show;
    const double left = std::max(0.0, options.budget - secondsSince(start));
    RenderSettings settings = defaultSettings(scene);
    options.settings.applyTo(settings);
    StudyPlan plan{settings, left, options.settings.has("size"), isReference(device)};
    addDenoisers(device, plan);
    const Study study =
        runOrClean(folder, claims, [&] { return runStudy(plan, prepare, observer); });
    progress.clear();
    writeAll(study, origin, folder);
    printChoices(choicesOf(study), "", study, origin.command);
    printChoices(denoisedChoicesOf(study), " after denoising", study, origin.command);
    std::printf("%s\n", (folder / "study.html").string().c_str());
    return reportGaps(study, folder);
}

} // namespace calotype
