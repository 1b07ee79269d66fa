#include "cli/commands.h"

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "cli/bench_report.h"
#include "cli/device_environment.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/interrupt_deadline.h"
#include "engine/bench.h"
#include "engine/bench_scene.h"
#include "engine/scene_settings.h"
#include "read/load.h"

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

BenchReport measure(const BenchScene& benchScene, const BenchOptions& options,
                    const DeviceOptions& device) {
    double loadSeconds = 0.0;
    const Scene scene = timed(loadSeconds, [&] {
        const InterruptDeadline deadline("interrupted while a scene was loaded");
        return benchScene.load();
    });
    RenderSettings settings = defaultSettings(scene);
    settings.samplesPerPixel = kBenchSamples;
    options.settings.applyTo(settings);
    return measureScene(scene, settings, options.repeats, device, loadSeconds, isInterrupted);
}

} // namespace

int benchCommand(const BenchOptions& options) {
    catchInterrupts();
    const DeviceOptions device = withEnvironment(options.device, false);
    const bool writesJson = !options.jsonFile.empty();
    if (writesJson)
        checkWritable(options.jsonFile);
    std::string lines;
    for (const BenchScene& scene : scenesOf(options)) {
        const BenchReport report = measure(scene, options, device);
        std::fputs(toText(scene.name, report).c_str(), stdout);
        std::fflush(stdout);
        lines += toJsonLine(scene.name, report, device.threads);
        if (writesJson)
            writeFileAtomically(options.jsonFile, lines);
    }
    return kExitDone;
}

} // namespace calotype
