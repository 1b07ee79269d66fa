#include "film/develop.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/check.h"
#include "film/error_estimate.h"

namespace calotype {
namespace {

bool contains(const LayerList& layers, const Layer* layer) {
    return std::ranges::find(layers, layer) != layers.end();
}

/// Removes the channels of a layer from a picture.
void remove(const Layer& layer, Picture& picture) {
    std::erase_if(picture.channels, [&](const Channel& channel) {
        return std::ranges::find(layer.channels, channel.name) != layer.channels.end();
    });
}

} // namespace

std::vector<Channel> channelsOf(const Layer& layer, const Film& film) {
    CALOTYPE_CHECK_EQ(layer.source == LayerSource::Replicas, true);
    return channelsOf(layer, pixelErrors(film));
}

std::vector<Channel> channelsOf(const Layer& layer, const AdaptiveFilm& film) {
    CALOTYPE_CHECK_EQ(layer.source == LayerSource::Replicas, true);
    return channelsOf(layer, pixelErrors(film));
}

LayerList neededLayers(const LayerList& wanted, const StageList& stages) {
    LayerList layers = wanted;
    for (const Stage* stage : stages)
        for (const std::string& name : stage->layers) {
            const Layer* layer = findLayer(name);
            CALOTYPE_CHECK_EQ(layer != nullptr, true);
            if (!contains(layers, layer))
                layers.push_back(layer);
        }
    return layers;
}

Picture develop(Image color, const LayerList& wanted, const StageList& stages,
                const std::function<std::vector<Channel>(const Layer&)>& makeChannels) {
    Picture picture{std::move(color)};
    const LayerList layers = neededLayers(wanted, stages);
    for (const Layer* layer : layers)
        for (Channel& channel : makeChannels(*layer))
            picture.channels.push_back(std::move(channel));
    for (const Stage* stage : stages)
        stage->run(picture);
    for (const Layer* layer : layers)
        if (!contains(wanted, layer))
            remove(*layer, picture);
    return picture;
}

} // namespace calotype
