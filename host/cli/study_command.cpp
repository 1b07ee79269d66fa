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
#include "engine/devices.h"
#include "engine/render_engine.h"
#include "engine/scene_settings.h"
#include "engine/spare_file.h"
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

void printChoices(const Study& study, const std::string& command) {
    for (const Choice& choice : choicesOf(study)) {
        std::string text = targetText(choice.target) + " error: ";
        if (choice.measurement) {
            const std::string& options = choice.measurement->variant.options;
            text += (options.empty() ? "the default" : options) + ", " +
                    durationText(choice.seconds) + (choice.isExtrapolated ? " (extrapolated)" : "");
            if (study.scale > 1.0)
                text +=
                    ", at the scene's own size about " + durationText(choice.seconds * study.scale);
            if (!options.empty() && choice.usual)
                text += " (default settings: " + durationText(*choice.usual) + ")";
            text += "\n  " + commandOf(choice, command);
        } else {
            text += "unknown: the time budget was too short";
        }
        std::printf("%s\n", text.c_str());
    }
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
        StageSeconds seconds;
        DeviceKeeper opened(device); // anew for each, so that none gets the kernels of another
        std::shared_ptr<RenderEngine> engine =
            makeEngine(opened, scene, {settings, false, false, onStep}, seconds);
        deadline.reset();
        if (engine->maxRadiance() == 0.0)
            throw SceneError(options.scene.path, "the scene has no light, so no error to study");
        origin.device = engine->info().name;
        return PreparedTracer{engine,        &engine->tracer(), engine->maxRadiance(),
                              seconds.build, seconds.compile,   [engine] { engine->finish(); }};
    };
    StudyObserver observer;
    observer.shouldStop = isInterrupted;
    observer.onProgress = show;
    const double left = std::max(0.0, options.budget - secondsSince(start));
    RenderSettings settings = defaultSettings(scene);
    options.settings.applyTo(settings);
    const StudyPlan plan{settings, left, options.settings.has("size"), isReference(device)};
    const Study study =
        runOrClean(folder, claims, [&] { return runStudy(plan, prepare, observer); });
    progress.clear();
    writeAll(study, origin, folder);
    printChoices(study, origin.command);
    std::printf("%s\n", (folder / "study.html").string().c_str());
    return reportGaps(study, folder);
}

} // namespace calotype
