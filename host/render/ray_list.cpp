#include "render/ray_list.h"

#include <algorithm>
#include <chrono>

#include "base/check.h"
#include "base/stopwatch.h"
#include "kernels/list_rays.spv.h"
#include "kernels/trace_rays.spv.h"
#include "render/dispatch_sizer.h"
#include "render/loop_budget.h"
#include "render/specialization.h"
#include "render/tiles.h"
#include "shared/bindings.h"

namespace calotype {
namespace {

/// Runs all groups in dispatches of bounded time. Returns the seconds that they took.
double runGroups(const Device& device, const ComputePipeline& pipeline,
                 shared::RayListParameters parameters, DispatchSizer& sizer) {
    using Clock = std::chrono::steady_clock;
    double sum = 0.0;
    for (parameters.firstGroup = 0; parameters.firstGroup < parameters.groupCount;) {
        const uint32_t count =
            std::min(sizer.tiles(), parameters.groupCount - parameters.firstGroup);
        const Clock::time_point start = Clock::now();
        pipeline.run(device, count, std::as_bytes(std::span(&parameters, 1)));
        const double seconds = secondsSince(start);
        sizer.update(count, seconds);
        sum += seconds;
        parameters.firstGroup += count;
    }
    return sum;
}

uint32_t mostGroups(const Device& device) { return device.limits().maxComputeWorkGroupCount[0]; }

std::vector<Binding> with(std::vector<Binding> bindings, std::initializer_list<Binding> more) {
    bindings.insert(bindings.end(), more);
    return bindings;
}

} // namespace

std::vector<shared::ListedRay> listRays(const Device& device, const GpuScene& scene,
                                        const SceneBuffers& buffers, const RenderSettings& settings,
                                        RayKind kind) {
    const Crop whole{0, 0, settings.width, settings.height};
    const uint32_t tiles = countTiles(whole);
    const Buffer camera = uploadBuffer(device, std::as_bytes(std::span(&scene.camera, 1)),
                                       vk::BufferUsageFlagBits::eUniformBuffer, "camera of rays");
    const Buffer rays(device, size_t{tiles} * kPixelsPerTile * sizeof(shared::ListedRay),
                      vk::BufferUsageFlagBits::eStorageBuffer, Buffer::Memory::Host, "rays");
    const ComputePipeline pipeline(
        device, {.name = "list rays",
                 .spirv = kListRaysSpirv,
                 .bindings = with(buffers.bindings(),
                                  {Binding::uniformBuffer(shared::kBindingCamera, camera),
                                   Binding::storageBuffer(shared::kBindingRays, rays)}),
                 .constants = specialization(device, scene.features, std::nullopt, settings.sampler,
                                             settings.transport),
                 .pushConstantBytes = sizeof(shared::RayListParameters)});
    shared::RayListParameters parameters{};
    parameters.imageSize = {settings.width, settings.height};
    parameters.groupCount = tiles;
    parameters.isShadow = kind.isShadow ? 1 : 0;
    parameters.bounces = kind.bounces;
    parameters.seed = settings.seed;
    parameters.lightCount = scene.lightCount;
    parameters.infiniteLight = scene.infiniteLight;
    parameters.lightTreeDepth = scene.lightTreeDepth;
    parameters.iterationBudget = loopBudget(device);
    DispatchSizer sizer(mostGroups(device));
    runGroups(device, pipeline, parameters, sizer);
    std::vector<shared::ListedRay> listed;
    std::ranges::copy_if(rays.mapped<shared::ListedRay>(), std::back_inserter(listed),
                         [](const shared::ListedRay& ray) { return ray.tMax > 0.0f; });
    return listed;
}

RayListTracer::RayListTracer(const Device& device, const GpuScene& scene,
                             const SceneBuffers& buffers, std::span<const shared::ListedRay> rays,
                             RayKind kind)
    : device_(device), sizer_(mostGroups(device)),
      rays_(uploadBuffer(device, std::as_bytes(rays), vk::BufferUsageFlagBits::eStorageBuffer,
                         "rays")),
      hits_(device, rays.size() * sizeof(shared::ListedHit),
            vk::BufferUsageFlagBits::eStorageBuffer, Buffer::Memory::Host, "hits of rays"),
      pipeline_(device,
                {.name = "trace rays",
                 .spirv = kTraceRaysSpirv,
                 .bindings = with(buffers.bindings(),
                                  {Binding::storageBuffer(shared::kBindingRays, rays_),
                                   Binding::storageBuffer(shared::kBindingListedHits, hits_)}),
                 .constants = specialization(device, scene.features),
                 .pushConstantBytes = sizeof(shared::RayListParameters)}) {
    parameters_.rayCount = static_cast<uint32_t>(rays.size());
    parameters_.groupCount =
        (parameters_.rayCount + shared::kRaysPerGroup - 1) / shared::kRaysPerGroup;
    parameters_.groupStride = coprimeStride(parameters_.groupCount);
    parameters_.isShadow = kind.isShadow ? 1 : 0;
    parameters_.iterationBudget = loopBudget(device);
}

double RayListTracer::trace() { return runGroups(device_, pipeline_, parameters_, sizer_); }

} // namespace calotype
