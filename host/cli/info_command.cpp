#include "cli/commands.h"

#include <cstdio>
#include <string>

#include "base/error.h"
#include "base/hexadecimal.h"
#include "cli/device_environment.h"
#include "cli/exit_code.h"
#include "cli/read_scene.h"
#include "engine/json_document.h"
#include "engine/scene_settings.h"
#include "engine/scene_summary.h"
#include "film/film_file.h"

namespace calotype {
namespace {

using Json = nlohmann::ordered_json;

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
    std::printf("host        about %.1f MiB for the samples of the picture\n",
                inMebibytes(fit.hostBytes));
    std::printf("largest     %.1f MiB in one buffer, of %.0f MiB\n",
                inMebibytes(summary.largestBytes), inMebibytes(fit.bufferBytes));
}

void printFeatures(const SceneSummary& summary) {
    std::string names;
    for (const std::string& feature : summary.features)
        names += (names.empty() ? "" : ", ") + feature;
    std::printf("kernel for  %s\n", names.c_str());
}

/// Null if no shape has an extent.
Json toJson(const Bounds3d& bounds) {
    if (bounds.isEmpty())
        return nullptr;
    const auto point = [](const glm::dvec3& p) { return Json({p.x, p.y, p.z}); };
    return {{"lower", point(bounds.lower)}, {"upper", point(bounds.upper)}};
}

void printJson(const Scene& scene, const SceneSummary& summary, const DeviceFit& fit,
               const RenderSettings& settings) {
    Json json = newJsonDocument();
    json["scene_hash"] = hexadecimal(scene.hash);
    json["resolution"] = {settings.width, settings.height};
    json["shapes"] = summary.shapes;
    json["triangles"] = summary.triangles;
    json["quadrics"] = summary.quadrics;
    json["materials"] = summary.materials;
    json["textures"] = summary.textures;
    json["lights"] = summary.lights;
    json["dropped_triangles"] = summary.droppedTriangles;
    json["bounds"] = toJson(summary.bounds);
    json["bvh"] = nameOf(summary.builder);
    json["tree"] = {{"nodes", summary.nodes},
                    {"children_per_node", summary.childrenPerNode},
                    {"depth", summary.depth},
                    {"leaves", summary.leaves},
                    {"primitives_per_leaf", summary.primitivesPerLeaf},
                    {"nodes_visited", summary.nodesVisited},
                    {"primitives_visited", summary.primitivesVisited}};
    json["features"] = summary.features;
    json["device"] = fit.device;
    json["memory_bytes"] = {{"scene", summary.sceneBytes},
                            {"textures", summary.textureBytes},
                            {"picture", fit.pictureBytes},
                            {"host", fit.hostBytes},
                            {"largest_buffer", summary.largestBytes},
                            {"device", fit.memoryBytes},
                            {"buffer_limit", fit.bufferBytes}};
    json["warnings"] = scene.warnings;
    std::fputs(jsonText(json).c_str(), stdout);
}

/// Throws UsageError if there are options that change nothing for a film.
void requireNoSceneOptions(const InfoOptions& options) {
    const SceneOptions& scene = options.scene;
    const ViewOptions& view = scene.view;
    if (!scene.overrides.empty() || scene.missingTextures != MissingTextures::Fail || view.from ||
        view.lookAt || view.up || view.fov || !options.device.device.empty() ||
        options.device.threads > 0 || !options.settings.options().empty())
        throw UsageError("only --json can be given with a film, and '" + scene.path + "' is one");
}

} // namespace

int infoCommand(const InfoOptions& options) {
    if (isFilm(options.scene.path)) {
        requireNoSceneOptions(options);
        return filmInfoCommand(options);
    }
    const DeviceOptions device = withEnvironment(options.device, false);
    const Scene scene =
        readScene(options.scene, options.settings, device, [](const std::string&, double) {});
    printWarnings(scene);
    RenderSettings settings = defaultSettings(scene);
    options.settings.applyTo(settings);
    const SceneSummary summary = summarize(scene, settings);
    if (options.asJson) {
        printJson(scene, summary, fitOf(settings, device), settings);
        return kExitDone;
    }
    printCounts(summary);
    printBvh(summary);
    printFeatures(summary);
    printMemory(summary, fitOf(settings, device), settings);
    return kExitDone;
}

} // namespace calotype
