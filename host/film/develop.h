#pragma once

#include <functional>
#include <vector>

#include "film/adaptive_film.h"
#include "film/film.h"
#include "image/layers.h"
#include "image/picture.h"

namespace calotype {

/// The channels of a layer that is made from a film alone: of any in layersOfFilms().
std::vector<Channel> channelsOf(const Layer& layer, const Film& film);
std::vector<Channel> channelsOf(const Layer& layer, const AdaptiveFilm& film);

/// Makes a picture of a colour and its layers. `makeChannels` returns the channels of a layer.
Picture develop(Image color, const LayerList& layers,
                const std::function<std::vector<Channel>(const Layer&)>& makeChannels);

} // namespace calotype
