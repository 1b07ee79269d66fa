#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <system_error>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/stopwatch.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/render_engine.h"
#include "scene/load.h"
#include "study/advice.h"
#include "study/csv.h"
#include "study/page.h"
#include "study/plot.h"
#include "study/study.h"

namespace calotype {
namespace {

using Clock = std::chrono::steady_clock;

StudySettings usualSettings(const Scene& scene) {
    StudySettings usual;
    usual.render.width = scene.film.width;
    usual.render.height = scene.film.height;
    usual.render.crop = {0, 0, scene.film.width, scene.film.height};
    usual.render.maxBounces = scene.render.maxBounces;
    usual.render.seed = scene.render.seed;
    usual.render.sampler = Sampler::Sobol;
    return usual;
}

/// Throws OutputError where the folder cannot be made or written to.
std::filesystem::path makeFolder(const StudyOptions& options) {
    std::filesystem::path folder = options.folder;
    if (folder.empty())
        folder = "study-" + std::filesystem::path(options.scene.path).stem().string();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw OutputError("cannot make the folder '" + folder.string() + "': " + error.message());
    for (const char* name : {"study.csv", "study.svg", "study.html"})
        checkWritable(folder / name);
    return folder;
}

void printChoices(const Study& study) {
    for (const Choice& choice : choicesOf(study)) {
        if (!choice.measurement) {
            std::printf("%s error: not known, the budget was too short\n",
                        targetText(choice.target).c_str());
            continue;
        }
        const std::string& options = choice.measurement->variant.options;
        std::printf("%s error: %s, %s here, about %s in the scene's size%s\n",
                    targetText(choice.target).c_str(),
                    options.empty() ? "the default" : options.c_str(),
                    durationText(choice.seconds).c_str(),
                    durationText(choice.seconds * study.scale).c_str(),
                    !options.empty() && choice.usual
                        ? (" (by default " + durationText(*choice.usual) + " here)").c_str()
                        : "");
    }
}

} // namespace

int studyCommand(const StudyOptions& options) {
    catchInterrupts();
    const Clock::time_point start = Clock::now();
    Progress progress(options.quiet);
    const auto show = [&](const std::string& what) {
        const double done = secondsSince(start) / options.budget;
        const double left = options.budget - secondsSince(start);
        progress.step(what + ", " + durationText(std::max(0.0, left)) + " left", done);
    };
    const auto throwIfInterrupted = [] {
        if (isInterrupted())
            throw Interrupted();
    };
    LoadOptions loadOptions;
    loadOptions.overrides = options.scene.overrides;
    loadOptions.missingTextures = options.scene.missingTextures;
    loadOptions.size = options.size;
    loadOptions.onProgress = [&](const std::string& what, double) {
        throwIfInterrupted();
        show("loading " + what);
    };
    Scene scene = loadScene(options.scene.path, loadOptions);
    progress.clear();
    const std::filesystem::path folder = makeFolder(options);
    for (const std::string& warning : scene.warnings)
        std::fprintf(stderr, "calotype: warning: %s\n", warning.c_str());

    StudyOrigin origin;
    origin.scene = std::filesystem::path(options.scene.path).filename().string();
    origin.command = "calotype render " + options.scene.path + " -o picture.exr";
    const PrepareTracer prepare = [&](const StudySettings& settings) {
        scene.lightChoice = settings.lightChoice;
        StageSeconds seconds;
        std::shared_ptr<RenderEngine> engine =
            makeEngine(options.device, scene,
                       {settings.render, false, settings.bvh, settings.compilesEverything,
                        [&](const std::string& what, double) { show(what); }},
                       seconds);
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
    const Study study =
        runStudy({usualSettings(scene), left, options.size.has_value()}, prepare, observer);
    progress.clear();
    if (study.measurements.empty())
        throw Error("interrupted before the default settings were measured; nothing was written");
    writeFileAtomically(folder / "study.csv", toCsv(study));
    writeFileAtomically(folder / "study.svg", toSvg(study, origin.scene));
    writeFileAtomically(folder / "study.html", toHtml(study, origin));
    printChoices(study);
    std::printf("%s\n", (folder / "study.html").string().c_str());
    if (study.isWhole)
        return kExitDone;
    std::fprintf(stderr, "calotype: interrupted; what was measured so far is in %s\n",
                 folder.string().c_str());
    return kExitOther;
}

} // namespace calotype
