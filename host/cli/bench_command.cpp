#include "cli/commands.h"

#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/error.h"
#include "cli/bench_report.h"
#include "cli/device_environment.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/interrupt_deadline.h"
#include "cli/output_claims.h"
#include "cli/read_scene.h"
#include "engine/bench.h"
#include "engine/bench_scene.h"
#include "engine/scene_settings.h"

namespace calotype {
namespace {

struct BenchScene {
    std::string name;
    std::function<Scene()> load;
};

LoadedScene load(const std::string& path, const BenchOptions& options,
                 const DeviceOptions& device) {
    SceneOptions scene;
    scene.path = path;
    scene.overrides = options.overrides;
    return readScene(scene, {}, device, [](const std::string&, double) { throwIfInterrupted(); });
}

std::vector<BenchScene> scenesOf(const BenchOptions& options, const DeviceOptions& device) {
    if (options.scenes.empty())
        return {{"generated", makeBenchScene},
                {"generated, many materials", makeManyMaterialScene}};
    std::vector<BenchScene> scenes;
    for (const std::string& path : options.scenes)
        scenes.push_back({path, [path, &options, &device] { return load(path, options, device); }});
    return scenes;
}

/// What must not be written is known once all scenes are loaded, so they are loaded once before the
/// first is measured. A new file is none of theirs.
OutputClaims claimJson(const BenchOptions& options, const DeviceOptions& device) {
    OutputClaims claims;
    if (options.jsonFile.empty())
        return claims;
    claims.reserve(options.scenes);
    claims.claim(options.jsonFile);
    std::error_code ignored;
    if (std::filesystem::exists(options.jsonFile, ignored))
        for (const std::string& path : options.scenes)
            claims.reserve(load(path, options, device).files());
    return claims;
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
    const OutputClaims claims = claimJson(options, device);
    std::string lines;
    try {
        for (const BenchScene& scene : scenesOf(options, device)) {
            const BenchReport report = measure(scene, options, device);
            std::fputs(toText(scene.name, report).c_str(), stdout);
            std::fflush(stdout);
            lines += toJsonLine(scene.name, report, device.threads);
            if (writesJson)
                writeFileAtomically(options.jsonFile, lines);
        }
    } catch (const Interrupted&) {
        throw Error(lines.empty() ? "interrupted before the first scene was measured"
                                  : "interrupted; the scenes before it were measured");
    }
    return kExitDone;
}

} // namespace calotype
