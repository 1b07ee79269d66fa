#include "engine/bench.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "engine/device_engine.h"
#include "render/ray_list.h"
#include "render/render_session.h"

namespace calotype {
namespace {

using ShouldStop = std::function<bool()>;

RenderTotals renderOnce(DeviceEngine& engine, const RenderSettings& settings,
                        const ShouldStop& shouldStop) {
    RenderSession session(engine.tracer(), settings, engine.maxRadiance());
    RenderObserver observer;
    observer.shouldStop = shouldStop;
    if (session.run(observer) != RenderEnding::AllSamples)
        throw Interrupted();
    return session.totals();
}

/// The rates of `repeats` measurements, after one that does not count.
Spread measure(uint32_t repeats, double count, const std::function<double()>& seconds,
               const ShouldStop& shouldStop) {
    seconds();
    std::vector<double> rates;
    for (uint32_t i = 0; i < repeats; ++i) {
        if (shouldStop())
            throw Interrupted();
        rates.push_back(count / seconds());
    }
    return spreadOf(std::move(rates));
}

std::vector<TraversalRate> measureTraversal(const DeviceEngine& engine,
                                            const RenderSettings& settings, uint32_t repeats,
                                            const ShouldStop& shouldStop) {
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
        rates.push_back({name, rays.size(),
                         measure(
                             repeats, count, [&] { return tracer.trace(); }, shouldStop)});
    }
    return rates;
}

} // namespace

Spread spreadOf(std::vector<double> numbers) {
    CALOTYPE_CHECK_LT(0u, numbers.size());
    std::ranges::sort(numbers);
    const size_t half = numbers.size() / 2;
    const double median =
        numbers.size() % 2 == 1 ? numbers[half] : 0.5 * (numbers[half - 1] + numbers[half]);
    return {median, numbers.front(), numbers.back()};
}

BenchReport measureScene(const Scene& scene, const RenderSettings& settings, uint32_t repeats,
                         const DeviceOptions& device, double loadSeconds,
                         const ShouldStop& shouldStop) {
    BenchReport report;
    report.repeats = repeats;
    report.settings = settings;
    report.seconds.load = loadSeconds;
    EngineRequest request{settings};
    request.settings.samplesPerPixel = (repeats + 2) * settings.samplesPerPixel;
    DeviceEngine engine(std::make_shared<const DeviceSession>(device), scene, request,
                        report.seconds);
    RenderSettings once = settings;
    once.samplesPerPixel = 1;
    report.firstPassSeconds = renderOnce(engine, once, shouldStop).firstSampleSeconds;
    const StageSeconds& seconds = report.seconds;
    report.seconds.firstSample =
        seconds.load + seconds.build + seconds.upload + seconds.compile + report.firstPassSeconds;
    renderOnce(engine, settings, shouldStop); // to warm up
    std::vector<double> paths;
    std::vector<double> rays;
    for (uint32_t i = 0; i < repeats; ++i) {
        const RenderTotals totals = renderOnce(engine, settings, shouldStop);
        paths.push_back(static_cast<double>(totals.paths) / totals.seconds);
        rays.push_back(static_cast<double>(totals.rays) / totals.seconds);
    }
    report.pathsPerSecond = spreadOf(std::move(paths));
    report.raysPerSecond = spreadOf(std::move(rays));
    report.traversal = measureTraversal(engine, settings, repeats, shouldStop);
    report.device = engine.info();
    report.tree = engine.tree();
    report.primitives = engine.packed().primitiveCount;
    report.deviceBytes = engine.deviceBytes();
    engine.finish();
    return report;
}

} // namespace calotype
