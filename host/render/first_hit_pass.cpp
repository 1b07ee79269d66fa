#include "render/first_hit_pass.h"

#include "base/check.h"
#include "kernels/first_hit.spv.h"
#include "shared/bindings.h"

namespace calotype {
namespace {

/// The kernel computes texture coordinates for every hit, but has them only if there are textures.
/// A scene without textures reads none, so the kind does not matter.
std::vector<uint32_t> constantsFor(const SceneFeatures& features) {
    std::vector<uint32_t> constants(features.enabled.begin(), features.enabled.end());
    constants[shared::kFeatureColorTextures] = VK_TRUE;
    return constants;
}

} // namespace

FirstHitPass::FirstHitPass(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
                           const SceneFeatures& features, const RenderSettings& settings)
    : origin_(scene.origin), parameters_(recordParameters(device, settings)),
      pass_(device, scene, buffers, settings.crop,
            {"first hit", kFirstHitSpirv, shared::kBindingFirstHits, constantsFor(features)}) {
    CALOTYPE_CHECK_EQ(scene.triangleUvs.size(), scene.triangles.size());
}

FirstHitImage FirstHitPass::run(const std::function<void(double)>& onProgress) {
    FirstHitImage image(parameters_.cropSize.x, parameters_.cropSize.y);
    cutPixels_ = 0;
    const auto take = [&](uint32_t x, uint32_t y, const shared::FirstHitRecord& record) {
        image.at(x, y) = toFirstHit(record);
        cutPixels_ += record.isCut;
    };
    pass_.run(parameters_, take, onProgress);
    return image;
}

FirstHit FirstHitPass::toFirstHit(const shared::FirstHitRecord& record) const {
    static_assert(kNoPrimitive == shared::kNone);
    FirstHit hit = record.hit;
    if (hit.primitive == kNoPrimitive)
        return {};
    hit.position = glm::vec3(glm::dvec3(hit.position) + origin_);
    return hit;
}

uint64_t firstHitPassBytes(const RenderSettings& settings) {
    return RecordPass<shared::FirstHitRecord>::deviceBytes(settings.crop);
}

} // namespace calotype
