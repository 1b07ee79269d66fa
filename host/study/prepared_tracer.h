#pragma once

#include <functional>
#include <memory>

#include "denoise/film_view.h"
#include "engine/clean_picture.h"
#include "render/block_tracer.h"

namespace calotype {

/// A tracer that is ready to render, and the time of its preparation.
struct PreparedTracer {
    std::shared_ptr<void> owner; ///< of the tracer, and of what `denoise` uses
    BlockTracer* tracer = nullptr;
    double maxRadiance = 0.0; ///< W/(m^2 sr)
    double buildSeconds = 0.0;
    double compileSeconds = 0.0;
    std::function<void()> finish = {}; ///< called after the render; throws errors that it found
    /// Denoises the whole blocks of a film, if the settings name a denoiser. It calls `onProgress`
    /// with the share done in [0, 1], which may throw.
    std::function<CleanPicture(const FilmView& film, const std::function<void(double)>& onProgress)>
        denoise = {};
    double featureSeconds = 0.0; ///< of finding the albedo and the normals that it uses
};

} // namespace calotype
