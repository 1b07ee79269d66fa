#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <OpenEXR/ImfForward.h>

#include "image/first_hit.h"
#include "image/pixel_error.h"

namespace calotype {

/// What of the first hits an EXR file can hold: a layer each, of channels LAYER.CHANNEL, as
/// compositors and Blender group them. All are 32-bit floats but primitive.ID, of 32-bit integers.
enum class FirstHitLayer : uint8_t {
    Albedo,    ///< albedo.R, .G, .B
    Normal,    ///< normal.X, .Y, .Z
    Depth,     ///< depth.Z
    Position,  ///< position.X, .Y, .Z
    Primitive, ///< primitive.ID
    Uv,        ///< uv.U, .V
};

/// Names of the layers, in the order of FirstHitLayer.
extern const std::array<std::string, 6> kFirstHitLayerNames;

/// The layers that an EXR file gets beside its picture.
struct ExrLayers {
    const FirstHitImage* hits = nullptr; ///< of the picture's size; null where no layer is wanted
    std::span<const FirstHitLayer> wanted = {};
    /// Of the picture's pixels, for the layer of error.SE, the standard error of luminance, and
    /// error.CI95, the interval; empty where that layer is not wanted.
    std::span<const PixelError> errors = {};
};

/// Name of the layer of errors.
inline const std::string kErrorLayerName = "error";

/// Declares the layers' channels.
void insertLayers(Imf::Header& header, const ExrLayers& layers);

/// Says where the layers' pixels lie, for the data window of `header`.
void insertLayers(Imf::FrameBuffer& buffer, const Imf::Header& header, const ExrLayers& layers);

/// Reads the layers of an EXR file; what of them it lacks is as in a FirstHit of nothing. Throws
/// SceneError if the file cannot be read, is damaged, or has none of them.
FirstHitImage readFirstHits(const std::filesystem::path& path);

} // namespace calotype
