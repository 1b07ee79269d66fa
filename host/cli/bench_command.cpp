#include "cli/commands.h"

#include <cstdio>
#include <functional>

#include "base/atomic_file.h"
#include "base/error.h"
#include "cli/bench_report.h"
#include "cli/bench_scene.h"
#include "cli/device_engine.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/timed.h"
#include "read/load.h"
#include "render/ray_list.h"
#include "render/render_session.h"

namespace calotype {
namespace {

struct BenchScene {
    std::string name;
    std::function<Scene()> load;
};

std::vector<BenchScene> scenesOf(const BenchOptions& options) {
    if (options.scenes.empty())
        return {{"generated", makeBenchScene},
                {"generated, many materials", makeManyMaterialScene}};
    std::vector<BenchScene> scenes;
    for (const std::string& path : options.scenes)
        scenes.push_back({path, [path, &options] {
                              LoadOptions load;
                              load.overrides = options.overrides;
                              return loadScene(path, load);
                          }});
    return scenes;
}

/// Throws Interrupted where the user wants no more.
RenderTotals renderOnce(DeviceEngine& engine, const RenderSettings& settings) {
    RenderSession session(engine.tracer(), settings, engine.maxRadiance());
    RenderObserver observer;
    observer.shouldStop = isInterrupted;
    if (session.run(observer) != RenderEnding::AllSamples)
        throw Interrupted();
    return session.totals();
}

/// The rates of `repeats` measurements after one that is not counted.
Spread measure(uint32_t repeats, double count, const std::function<double()>& seconds) {
    seconds();
    std::vector<double> rates;
    for (uint32_t i = 0; i < repeats; ++i) {
        if (isInterrupted())
            throw Interrupted();
        rates.push_back(count / seconds());
    }
    return spreadOf(std::move(rates));
}

std::vector<TraversalRate> measureTraversal(const DeviceEngine& engine,
                                            const RenderSettings& settings, uint32_t repeats) {
    const std::pair<const char*, RayKind> kinds[] = {{"primary", RayKind::afterBounces(0)},
                                                     {"bounced", RayKind::afterBounces(3)},
                                                     {"shadow", RayKind::shadow()}};
    std::vector<TraversalRate> rates;
    for (const auto& [name, kind] : kinds) {
        const std::vector<shared::ListedRay> rays =
            listRays(engine.device(), engine.packed(), engine.buffers(), settings, kind);
        if (rays.empty())
            continue;
        RayListTracer tracer(engine.device(), engine.packed(), engine.buffers(), rays, kind);
        const auto count = static_cast<double>(rays.size());
        rates.push_back(
            {name, rays.size(), measure(repeats, count, [&] { return tracer.trace(); })});
    }
    return rates;
}

BenchReport benchScene(const BenchScene& benchScene, const BenchOptions& options) {
    BenchReport report;
    report.scene = benchScene.name;
    report.threads = options.device.threads;
    report.repeats = options.repeats;
    report.compilesEverything = options.compilesEverything;
    const Scene scene = timed(report.seconds.load, benchScene.load);
    RenderSettings& settings = report.settings;
    settings = {scene.film.width,
                scene.film.height,
                {0, 0, scene.film.width, scene.film.height},
                0,
                1,
                scene.render.maxBounces,
                scene.render.seed,
                options.sampler};
    EngineRequest request{settings, false, options.bvh, options.compilesEverything,
                          [](const std::string&, double) {}};
    request.settings.samplesPerPixel = (options.repeats + 2) * options.samplesPerPixel;
    DeviceEngine engine(options.device, scene, request, report.seconds);
    report.firstPassSeconds = renderOnce(engine, settings).firstSampleSeconds;
    const StageSeconds& seconds = report.seconds;
    report.seconds.firstSample =
        seconds.load + seconds.build + seconds.upload + seconds.compile + report.firstPassSeconds;
    settings.samplesPerPixel = options.samplesPerPixel;
    renderOnce(engine, settings); // to warm up
    std::vector<double> paths;
    std::vector<double> rays;
    for (uint32_t i = 0; i < options.repeats; ++i) {
        const RenderTotals totals = renderOnce(engine, settings);
        paths.push_back(static_cast<double>(totals.paths) / totals.seconds);
        rays.push_back(static_cast<double>(totals.rays) / totals.seconds);
    }
    report.pathsPerSecond = spreadOf(std::move(paths));
    report.raysPerSecond = spreadOf(std::move(rays));
    report.traversal = measureTraversal(engine, settings, options.repeats);
    report.device = engine.info();
    report.primitives = engine.packed().primitiveCount;
    report.deviceBytes = engine.deviceBytes();
    engine.finish();
    return report;
}

} // namespace

int benchCommand(const BenchOptions& options) {
    catchInterrupts();
    const bool writesJson = !options.jsonFile.empty();
    if (writesJson)
        checkWritable(options.jsonFile);
    std::string lines;
    for (const BenchScene& scene : scenesOf(options)) {
        const BenchReport report = benchScene(scene, options);
        std::fputs(toText(report).c_str(), stdout);
        std::fflush(stdout);
        lines += toJsonLine(report);
        if (writesJson)
            writeFileAtomically(options.jsonFile, lines);
    }
    return kExitDone;
}

} // namespace calotype
