#include "render/feature_pass.h"

#include "kernels/features.spv.h"
#include "render/specialization.h"
#include "shared/bindings.h"

namespace calotype {
namespace {

shared::RecordParameters parametersFor(const Device& device, const GpuScene& scene,
                                       const RenderSettings& settings) {
    shared::RecordParameters parameters = recordParameters(device, settings);
    parameters.seed = featureSeed(settings.seed);
    parameters.infiniteLight = scene.infiniteLight;
    return parameters;
}

} // namespace

FeaturePass::FeaturePass(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
                         const SceneFeatures& features, const RenderSettings& settings)
    : parameters_(parametersFor(device, scene, settings)),
      pass_(device, scene, buffers, settings.crop,
            {"features", kFeaturesSpirv, shared::kBindingFeatures,
             specialization(device, features, {}, settings.sampler, settings.transport)}) {}

FeatureImage FeaturePass::run(uint32_t rays, const std::function<void(double)>& onProgress,
                              const OnPrimitives& onPrimitives) {
    static_assert(kNoPrimitive == shared::kNone);
    FeatureImage image(parameters_.cropSize.x, parameters_.cropSize.y);
    PixelGrid<uint32_t> primitives(image.width, image.height);
    cutRays_ = 0;
    const auto take = [&](uint32_t x, uint32_t y, const shared::FeatureRecord& record) {
        add(record.features, image.at(x, y));
        primitives.at(x, y) = record.primitive;
        cutRays_ += record.isCut;
    };
    for (uint32_t ray = 0; ray < rays; ++ray) {
        parameters_.sampleIndex = ray;
        const auto onPart = [&](double done) {
            if (onProgress)
                onProgress((ray + done) / rays);
        };
        pass_.run(parameters_, take, onPart);
        if (onPrimitives)
            onPrimitives(primitives.pixels);
    }
    for (Features& pixel : image.pixels)
        pixel = meanFeatures(pixel, rays);
    return image;
}

uint64_t featurePassBytes(const RenderSettings& settings) {
    return RecordPass<shared::FeatureRecord>::deviceBytes(settings.crop);
}

} // namespace calotype
