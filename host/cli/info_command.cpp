#include "cli/commands.h"

#include <cstdio>
#include <string>

#include "base/error.h"
#include "cli/device_environment.h"
#include "cli/exit_code.h"
#include "cli/read_scene.h"
#include "engine/scene_settings.h"
#include "engine/scene_summary.h"
#include "film/film_file.h"

namespace calotype {
namespace {

double inMebibytes(uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

void printCounts(const SceneSummary& summary) {
    std::printf("shapes      %zu (%zu triangles, %zu quadrics and disks)\n", summary.shapes,
                summary.triangles, summary.quadrics);
    std::printf("materials   %zu\n", summary.materials);
    std::printf("textures    %zu (%.1f MiB on the device)\n", summary.textures,
                inMebibytes(summary.textureBytes));
    std::printf("lights      %u\n", summary.lights);
    std::printf("dropped     %llu triangles without area\n",
                static_cast<unsigned long long>(summary.droppedTriangles));
    const Bounds3d& bounds = summary.bounds;
    if (!bounds.isEmpty())
        std::printf("bounds      (%g, %g, %g) to (%g, %g, %g) m\n", bounds.lower.x, bounds.lower.y,
                    bounds.lower.z, bounds.upper.x, bounds.upper.y, bounds.upper.z);
}

void printBvh(const SceneSummary& summary) {
    std::printf("BVH         by %s, %zu nodes of %.2f children, depth %u of %u, %zu leaves of %.2f "
                "primitives; a ray visits %.1f nodes and %.1f primitives\n",
                summary.builder == BvhBuilder::Median ? "median split" : "surface area heuristic",
                summary.nodes, summary.childrenPerNode, summary.depth, summary.mostDepth,
                summary.leaves, summary.primitivesPerLeaf, summary.nodesVisited,
                summary.primitivesVisited);
}

void printMemory(const SceneSummary& summary, const DeviceFit& fit,
                 const RenderSettings& settings) {
    std::printf("device      %s (%s)\n", fit.device.c_str(), fit.reason.c_str());
    std::printf("memory      %.1f MiB scene + %.1f MiB picture of %ux%u, of %.0f MiB\n",
                inMebibytes(summary.sceneBytes), inMebibytes(fit.pictureBytes), settings.width,
                settings.height, inMebibytes(fit.memoryBytes));
    std::printf("largest     %.1f MiB in one buffer, of %.0f MiB\n",
                inMebibytes(summary.largestBytes), inMebibytes(fit.bufferBytes));
}

void printFeatures(const SceneSummary& summary) {
    std::string names;
    for (const std::string& feature : summary.features)
        names += (names.empty() ? "" : ", ") + feature;
    std::printf("kernel for  %s\n", names.c_str());
}

} // namespace

int infoCommand(const InfoOptions& options) {
    if (isFilm(options.scene.path)) {
        if (!options.scene.overrides.empty() || !options.device.device.empty() ||
            options.settings.has("bvh"))
            throw UsageError("--set, --device and --bvh are for scenes; '" + options.scene.path +
                             "' is a film");
        return filmInfoCommand(options);
    }
    if (options.asJson)
        throw UsageError("--json is for films, and '" + options.scene.path + "' is none");
    const DeviceOptions device = withEnvironment(options.device, false);
    const Scene scene =
        readScene(options.scene, options.settings, device, [](const std::string&, double) {});
    printWarnings(scene);
    RenderSettings settings = defaultSettings(scene);
    options.settings.applyTo(settings);
    const SceneSummary summary = summarize(scene, settings);
    printCounts(summary);
    printBvh(summary);
    printFeatures(summary);
    printMemory(summary, fitOf(settings, device), settings);
    return kExitDone;
}

} // namespace calotype
