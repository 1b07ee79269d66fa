#include "reference/reference_tracer.h"

#include <variant>

#include <glm/geometric.hpp>

#include "reference/bsdf.h"
#include "reference/camera.h"
#include "reference/features.h"

namespace calotype::reference {
namespace {

std::vector<Texture> withFilter(std::vector<Texture> textures,
                                const std::optional<TextureFilter>& filter) {
    for (Texture& texture : textures)
        if (auto* image = std::get_if<ImageTexture>(&texture.source); image && filter)
            image->filter = *filter;
    return textures;
}

} // namespace

ReferenceTracer::ReferenceTracer(const Scene& scene, const glm::uvec2& imageSize,
                                 uint32_t maxBounces, const TransportSettings& transport,
                                 const std::optional<TextureFilter>& filter)
    : scene_(scene), textures_(withFilter(scene.textures, filter)), imageSize_(imageSize),
      maxBounces_(maxBounces), transport_(transport), geometry_(scene),
      lights_(scene, geometry_, transport.lightChoice) {}

PathSetup ReferenceTracer::setup() const {
    return {scene_, textures_, geometry_, lights_, imageSize_, maxBounces_, transport_};
}

PathSample ReferenceTracer::trace(const SampleId& id) const { return tracePath(setup(), id); }

RayFeatures ReferenceTracer::features(const SampleId& id) const {
    return traceFeatures(setup(), id);
}

FirstHit ReferenceTracer::firstHitAt(const glm::dvec2& filmPosition) const {
    const glm::dvec2 lensCentre(0.0);
    Ray ray = cameraRay(scene_.camera, imageSize_, filmPosition, lensCentre);
    const glm::dvec3 start = ray.origin;
    while (const std::optional<Hit> hit = geometry_.closest(ray)) {
        const Surface surface = geometry_.surface(*hit, ray);
        const Light* light = lights_.ofPrimitive(surface.primitive);
        const Material& material = scene_.materials[surface.material];
        const bool isSeen = !(light && light->isHiddenFromCamera()) &&
                            alphaAt(material, textures_, surface.uv) >= 0.5;
        if (!isSeen) {
            ray.origin = leaveSurface(surface, ray.direction);
            continue;
        }
        const double side = glm::dot(ray.direction, surface.ng) > 0.0 ? -1.0 : 1.0;
        const bool isClear = material.type == MaterialType::Dielectric;
        FirstHit first;
        first.albedo =
            isClear ? glm::vec3(1.0f) : glm::vec3(colorAt(material, textures_, surface.uv));
        first.normal = glm::vec3(side * shadingNormal(material, textures_, surface));
        first.position = glm::vec3(surface.position);
        first.depth = static_cast<float>(glm::dot(surface.position - start, scene_.camera.forward));
        first.primitive = surface.primitive;
        first.uv = glm::vec2(surface.uv);
        return first;
    }
    return {};
}

} // namespace calotype::reference
