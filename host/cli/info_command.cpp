#include "cli/commands.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "accel/build_bvh.h"
#include "base/error.h"
#include "cli/device_session.h"
#include "cli/exit_code.h"
#include "cli/read_scene.h"
#include "film/film_file.h"
#include "pack/gpu_scene.h"
#include "render/path_tracer.h"
#include "scene/scene_bounds.h"
#include "shared/limits.h"

namespace calotype {
namespace {

void printCounts(const Scene& scene, const GpuScene& packed,
                 std::span<const Primitive> primitives) {
    const auto quadrics = static_cast<size_t>(
        std::count_if(primitives.begin(), primitives.end(), [](const Primitive& primitive) {
            return primitive.kind == PrimitiveKind::Quadric;
        }));
    std::printf("shapes      %zu (%zu triangles, %zu quadrics and disks)\n", scene.shapes.size(),
                primitives.size() - quadrics, quadrics);
    std::printf("materials   %zu\n", scene.materials.size());
    std::printf("textures    %zu (%.1f MiB on the device)\n", scene.textures.size(),
                static_cast<double>(packed.texelRows.size() * sizeof(packed.texelRows[0])) /
                    (1 << 20));
    std::printf("lights      %u\n", packed.lightCount);
    std::printf("dropped     %llu triangles without area\n",
                static_cast<unsigned long long>(scene.droppedTriangles));
    const Bounds3d bounds = sceneBounds(scene);
    if (!bounds.isEmpty())
        std::printf("bounds      (%g, %g, %g) to (%g, %g, %g) m\n", bounds.lower.x, bounds.lower.y,
                    bounds.lower.z, bounds.upper.x, bounds.upper.y, bounds.upper.z);
}

void printBvh(const Bvh& bvh, BvhBuilder builder) {
    const BvhStatistics statistics = bvhStatistics(bvh);
    std::printf("BVH         by %s, %zu nodes of %.2f children, depth %u of %u, %zu leaves of %.2f "
                "primitives; a ray visits %.1f nodes and %.1f primitives\n",
                builder == BvhBuilder::Median ? "median split" : "surface area heuristic",
                statistics.nodes, statistics.childrenPerNode, bvh.depth, shared::kMaxBvhDepth,
                statistics.leaves, statistics.primitivesPerLeaf, statistics.nodesVisited,
                statistics.primitivesVisited);
}

void printMemory(const Device& device, const GpuScene& packed, const RenderSettings& settings) {
    const auto mib = [](uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); };
    const uint64_t largest = std::max({packed.nodes.size() * sizeof(shared::BvhNode),
                                       packed.triangles.size() * sizeof(shared::Triangle),
                                       packed.texelRows.size() * sizeof(packed.texelRows[0])});
    std::printf("device      %s (%s)\n", device.info().name.c_str(),
                device.choice().reason.c_str());
    std::printf("memory      %.1f MiB scene + %.1f MiB picture of %ux%u, of %.0f MiB\n",
                mib(packed.bytes()), mib(pathTracerBytes(device, settings)), settings.width,
                settings.height, mib(device.memorySize()));
    std::printf("largest     %.1f MiB in one buffer, of %.0f MiB\n", mib(largest),
                mib(uint64_t{device.limits().maxTexelBufferElements} * 16));
}

void printFeatures(const SceneFeatures& features) {
    std::string names;
    for (size_t i = 0; i < kFeatureNames.size(); ++i)
        if (features.enabled[i])
            names += (names.empty() ? "" : ", ") + std::string(kFeatureNames[i]);
    std::printf("kernel for  %s\n", names.c_str());
}

} // namespace

int infoCommand(const InfoOptions& options) {
    if (isFilm(options.scene.path)) {
        if (!options.scene.overrides.empty() || !options.device.device.empty() || options.bvh)
            throw UsageError("--set, --device and --bvh are for scenes; '" + options.scene.path +
                             "' is a film");
        return filmInfoCommand(options);
    }
    if (options.asJson)
        throw UsageError("--json is for films, and '" + options.scene.path + "' is none");
    const Scene scene = readScene(options.scene, std::nullopt, [](const std::string&, double) {});
    printWarnings(scene);
    const glm::dvec3 origin = packingOrigin(scene);
    const std::vector<Primitive> primitives = collectPrimitives(scene, origin);
    const FilmSettings& film = scene.film;
    const uint64_t paths = uint64_t{film.width} * film.height * scene.render.samplesPerPixel;
    const BvhBuilder builder = options.bvh.value_or(quickestBuilder(primitives.size(), paths));
    const Bvh bvh = buildBvh(primitives, builder);
    const GpuScene packed =
        packScene(scene, primitives, bvh, origin, static_cast<double>(film.width) / film.height);
    RenderSettings settings;
    settings.width = film.width;
    settings.height = film.height;
    settings.crop = {0, 0, film.width, film.height};

    printCounts(scene, packed, primitives);
    printBvh(bvh, builder);
    printFeatures(packed.features);
    const DeviceSession session(options.device);
    printMemory(session.device(), packed, settings);
    session.throwOnValidationMessages();
    return kExitDone;
}

} // namespace calotype
