#include "film/develop.h"

#include <utility>

#include "base/check.h"
#include "film/error_estimate.h"

namespace calotype {

std::vector<Channel> channelsOf(const Layer& layer, const Film& film) {
    CALOTYPE_CHECK_EQ(layer.source == LayerSource::Replicas, true);
    return channelsOf(layer, pixelErrors(film));
}

std::vector<Channel> channelsOf(const Layer& layer, const AdaptiveFilm& film) {
    CALOTYPE_CHECK_EQ(layer.source == LayerSource::Replicas, true);
    return channelsOf(layer, pixelErrors(film));
}

Picture develop(Image color, const LayerList& layers,
                const std::function<std::vector<Channel>(const Layer&)>& makeChannels) {
    Picture picture{std::move(color)};
    for (const Layer* layer : layers)
        for (Channel& channel : makeChannels(*layer))
            picture.channels.push_back(std::move(channel));
    return picture;
}

} // namespace calotype
