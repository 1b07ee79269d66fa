#include "engine/mattes.h"

#include "image/cryptomatte.h"
#include "image/layers.h"

namespace calotype {

Mattes::Mattes(const Scene& scene, const LayerList& layers, size_t pixels) {
    for (const Layer* layer : layers)
        if (layer->source == LayerSource::Mattes)
            mattes_[layer] = {layer->matte == MatteKind::Objects ? objectNames(scene)
                                                                 : materialNames(scene),
                              Coverage(pixels)};
}

void Mattes::addRay(std::span<const uint32_t> primitives) {
    for (auto& [layer, matte] : mattes_)
        matte.coverage.addRay(primitives, matte.names.ofPrimitives);
}

std::vector<Channel> Mattes::channelsOf(const Layer& layer) const {
    const Matte& matte = mattes_.at(&layer);
    std::vector<float> ids;
    for (const std::string& name : matte.names.names)
        ids.push_back(cryptomatteId(name));
    return calotype::channelsOf(layer, matte.coverage, ids);
}

void Mattes::describe(Picture& picture) const {
    for (const auto& [layer, matte] : mattes_)
        for (Attribute& attribute : cryptomatteAttributes(layer->typeName, matte.names.names))
            picture.metadata.push_back(std::move(attribute));
}

} // namespace calotype
