#include "render/reference_features.h"

#include "render/feature_rays.h"
#include "render/reference_rows.h"

namespace calotype {

FeatureImage referenceFeatures(const reference::ReferenceTracer& tracer,
                               const RenderSettings& settings, uint32_t rays, uint32_t threads,
                               const std::function<void(double)>& onProgress,
                               const OnPrimitives& onPrimitives) {
    const Crop& crop = settings.crop;
    FeatureImage image(crop.width, crop.height);
    PixelGrid<uint32_t> primitives(crop.width, crop.height);
    for (uint32_t ray = 0; ray < rays; ++ray) {
        const auto find = [&](uint32_t x, uint32_t y) {
            const RayFeatures found = tracer.features(
                {{crop.x + x, crop.y + y}, ray, featureSeed(settings.seed), settings.sampler});
            add(found.features, image.at(x, y));
            primitives.at(x, y) = found.primitive;
        };
        const auto onPart = [&](double done) {
            if (onProgress)
                onProgress((ray + done) / rays);
        };
        forEachPixel(crop, threads, find, onPart);
        if (onPrimitives)
            onPrimitives(primitives.pixels);
    }
    for (Features& pixel : image.pixels)
        pixel = meanFeatures(pixel, rays);
    return image;
}

} // namespace calotype
