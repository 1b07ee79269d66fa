#include "support/render_scene.h"

#include "engine/scene_settings.h"
#include "read/load.h"
#include "support/device_tracer.h"
#include "support/paths.h"

namespace calotype::test {

RenderedScene renderScene(const Scene& scene, const RenderWish& wish) {
    RenderSettings settings;
    settings.width = wish.width.value_or(scene.film.width);
    settings.height = wish.height.value_or(scene.film.height);
    settings.crop = wish.crop.value_or(Crop{0, 0, settings.width, settings.height});
    settings.samplesPerPixel = wish.samplesPerPixel.value_or(scene.render.samplesPerPixel);
    settings.maxBounces = wish.maxBounces.value_or(scene.render.maxBounces);
    settings.seed = wish.seed.value_or(scene.render.seed);
    settings.sampler = wish.sampler;
    settings.transport = wish.transport;
    settings.transport.lightChoice = wish.lightChoice.value_or(defaultLightChoice(scene));

    DeviceTracer device(scene, settings, wish.features, wish.tuning);
    RenderSession session(device.tracer(), settings, device.packed().maxRadiance);
    session.run(wish.observer, wish.passSamples, wish.goal);
    return {session.picture(), session.totals(), device.packed().features, session.film()};
}

Scene projectScene(const std::string& path) {
    return loadScene(std::string(kProjectFolder) + "/" + path);
}

} // namespace calotype::test
