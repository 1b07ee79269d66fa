#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace calotype {

/// Where the values of a layer come from.
enum class LayerSource : uint8_t {
    FirstHit, ///< a FirstHit for each pixel
    Averaged, ///< Features for each pixel
    Replicas, ///< a PixelError for each pixel
    Mattes,   ///< a Coverage of the picture
};

/// What a matte tells apart.
enum class MatteKind : uint8_t { Objects, Materials };

/// A group of channels of a picture: a row of the table in shared/layers.h.
struct Layer {
    std::string name; ///< in --aov and in EXR files
    LayerSource source;
    std::vector<std::string> channels; ///< their full names: "albedo.R", "albedo.G", "albedo.B"
    bool isInteger = false;            ///< 32-bit unsigned integers; else 32-bit floats
    std::string help;                  ///< meaning and unit of its values
    size_t offset = 0;         ///< of its values in a FirstHit, Features or a PixelError, bytes
    std::string typeName = {}; ///< of mattes: before the ranks in the names of `channels`
    MatteKind matte = MatteKind::Objects; ///< of mattes
};

using LayerList = std::vector<const Layer*>;

/// The table.
LayerList allLayers();

/// The layers that can be made from a film alone: those whose source is Replicas.
LayerList layersOfFilms();

/// The layer with that name; null if there is none.
const Layer* findLayer(std::string_view name);

/// Whether one of the layers has that source.
bool hasSource(const LayerList& layers, LayerSource source);

/// "albedo, normal".
std::string namesOf(const LayerList& layers);

} // namespace calotype
