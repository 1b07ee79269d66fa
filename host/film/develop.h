#pragma once

#include <functional>
#include <vector>

#include "film/adaptive_film.h"
#include "film/film.h"
#include "film/stages.h"
#include "image/layers.h"
#include "image/picture.h"

namespace calotype {

/// The channels of a layer that is made from a film alone: of any in layersOfFilms().
std::vector<Channel> channelsOf(const Layer& layer, const Film& film);
std::vector<Channel> channelsOf(const Layer& layer, const AdaptiveFilm& film);

/// The layers that a picture needs: those that are wanted, then what else its stages read.
LayerList neededLayers(const LayerList& wanted, const StageList& stages);

/// Makes a picture of a colour and its layers, and runs the stages on it, one after the other.
/// `makeChannels` returns the channels of a layer; it is called for each of neededLayers. The
/// picture has the layers that are wanted, and what the stages add.
Picture develop(Image color, const LayerList& wanted, const StageList& stages,
                const std::function<std::vector<Channel>(const Layer&)>& makeChannels);

} // namespace calotype
