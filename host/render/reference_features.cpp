#include "render/reference_features.h"

#include "render/feature_rays.h"
#include "render/reference_rows.h"

namespace calotype {

FeatureImage referenceFeatures(const reference::ReferenceTracer& tracer,
                               const RenderSettings& settings, uint32_t rays, uint32_t threads,
                               const std::function<void(double)>& onProgress) {
    const Crop& crop = settings.crop;
    FeatureImage image(crop.width, crop.height);
    const auto find = [&](uint32_t x, uint32_t y) {
        Features sum;
        for (uint32_t ray = 0; ray < rays; ++ray)
            add(tracer.features(
                    {{crop.x + x, crop.y + y}, ray, featureSeed(settings.seed), settings.sampler}),
                sum);
        image.at(x, y) = meanFeatures(sum, rays);
    };
    forEachPixel(crop, threads, find, onProgress);
    return image;
}

} // namespace calotype
