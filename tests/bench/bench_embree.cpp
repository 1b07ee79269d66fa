// The same rays through Calotype's traversal and through Embree's rtcIntersect1 and rtcOccluded1,
// in turn. Prints one line of JSON: millions of rays a second of either, medians over the rounds,
// and their ratio.
// usage: bench_embree [ROUNDS]
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <embree3/rtcore.h>
#include <nlohmann/json.hpp>

#include "engine/bench.h"
#include "engine/bench_scene.h"
#include "engine/device_engine.h"
#include "engine/scene_settings.h"
#include "render/ray_list.h"

namespace {

using namespace calotype;

class EmbreeScene {
public:
    explicit EmbreeScene(const std::vector<shared::Triangle>& triangles)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * triangles.size()));
        auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size()));
        for (uint32_t i = 0; i < triangles.size(); ++i) {
            vertices[3 * i] = triangles[i].v0;
            vertices[3 * i + 1] = triangles[i].v1;
            vertices[3 * i + 2] = triangles[i].v2;
        }
        for (uint32_t i = 0; i < 3 * triangles.size(); ++i)
            indices[i] = i;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// Traces all rays on all cores; returns the seconds it took, and counts the hits.
    double trace(const std::vector<shared::ListedRay>& rays, bool anyHit, uint64_t& hits) const {
        constexpr size_t kRaysAtATime = 1024;
        std::atomic<size_t> next = 0;
        std::atomic<uint64_t> hitCount = 0;
        const auto work = [&] {
            uint64_t count = 0;
            for (size_t first = next.fetch_add(kRaysAtATime); first < rays.size();
                 first = next.fetch_add(kRaysAtATime))
                for (size_t i = first; i < std::min(first + kRaysAtATime, rays.size()); ++i)
                    count += anyHit ? isOccluded(rays[i]) : hitsAnything(rays[i]);
            hitCount += count;
        };
        const auto start = std::chrono::steady_clock::now();
        {
            std::vector<std::jthread> threads;
            for (uint32_t i = 1; i < std::thread::hardware_concurrency(); ++i)
                threads.emplace_back(work);
            work();
        }
        const auto end = std::chrono::steady_clock::now();
        hits = hitCount;
        return std::chrono::duration<double>(end - start).count();
    }

private:
    static RTCRay rayOf(const shared::ListedRay& listed) {
        RTCRay ray{};
        ray.org_x = listed.origin.x;
        ray.org_y = listed.origin.y;
        ray.org_z = listed.origin.z;
        ray.dir_x = listed.direction.x;
        ray.dir_y = listed.direction.y;
        ray.dir_z = listed.direction.z;
        ray.tfar = listed.tMax;
        ray.mask = ~0u;
        return ray;
    }

    bool hitsAnything(const shared::ListedRay& listed) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit ray{};
        ray.ray = rayOf(listed);
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &ray);
        return ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }

    bool isOccluded(const shared::ListedRay& listed) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay ray = rayOf(listed);
        rtcOccluded1(scene_, &context, &ray);
        return ray.tfar < 0.0f;
    }

    RTCDevice device_;
    RTCScene scene_;
};

/// Lists of rays that count as one measurement.
struct Workload {
    std::string name;
    std::vector<RayKind> kinds;
};

nlohmann::ordered_json compare(const Workload& workload, const DeviceEngine& engine,
                               const EmbreeScene& embree, const RenderSettings& settings,
                               uint32_t rounds) {
    std::vector<std::vector<shared::ListedRay>> lists;
    std::vector<RayListTracer> tracers;
    uint64_t count = 0;
    for (const RayKind& kind : workload.kinds) {
        lists.push_back(
            listRays(engine.device(), engine.packed(), engine.buffers(), settings, kind));
        tracers.emplace_back(engine.device(), engine.packed(), engine.buffers(), lists.back(),
                             kind);
        count += lists.back().size();
    }
    std::vector<double> ours;
    std::vector<double> theirs;
    uint64_t ourHits = 0;
    uint64_t theirHits = 0;
    for (uint32_t round = 0; round <= rounds; ++round) {
        double ourSeconds = 0.0;
        double theirSeconds = 0.0;
        theirHits = 0;
        for (size_t i = 0; i < lists.size(); ++i) {
            ourSeconds += tracers[i].trace();
            uint64_t hits = 0;
            theirSeconds += embree.trace(lists[i], workload.kinds[i].isShadow, hits);
            theirHits += hits;
        }
        if (round == 0) // to warm up
            continue;
        ours.push_back(1e-6 * static_cast<double>(count) / ourSeconds);
        theirs.push_back(1e-6 * static_cast<double>(count) / theirSeconds);
    }
    for (const RayListTracer& tracer : tracers)
        for (const shared::ListedHit& hit : tracer.hits())
            ourHits += hit.primitive != shared::kNone ? 1 : 0;
    const Spread our = spreadOf(ours);
    const Spread their = spreadOf(theirs);
    return {{"rays", count},
            {"hits", ourHits},
            {"embree_hits", theirHits},
            {"calotype", our.median},
            {"embree", their.median},
            {"ratio", our.median / their.median},
            {"best_ratio", our.greatest / their.greatest}};
}

} // namespace

int main(int argc, char** argv) {
    const auto rounds = static_cast<uint32_t>(argc > 1 ? std::atoi(argv[1]) : 7);
    const Scene scene = makeBenchScene();
    RenderSettings settings = defaultSettings(scene);
    settings.samplesPerPixel = 3;
    settings.maxBounces = 0;
    settings.sampler = Sampler::Independent;
    settings.bvh = BvhBuilder::Sah;
    StageSeconds seconds;
    const DeviceEngine engine(std::make_shared<const DeviceSession>(DeviceOptions{}), scene,
                              {settings}, seconds);
    const EmbreeScene embree(engine.packed().triangles);
    const std::vector<Workload> workloads = {{"primary", {RayKind::afterBounces(0)}},
                                             {"path",
                                              {RayKind::afterBounces(0), RayKind::afterBounces(1),
                                               RayKind::afterBounces(2), RayKind::afterBounces(3)}},
                                             {"bounced", {RayKind::afterBounces(3)}},
                                             {"shadow", {RayKind::shadow()}}};
    nlohmann::ordered_json json;
    json["device"] = engine.info().name;
    for (const Workload& workload : workloads)
        json[workload.name] = compare(workload, engine, embree, settings, rounds);
    std::printf("%s\n", json.dump().c_str());
    return 0;
}
