#pragma once

#include <cstdint>
#include <optional>

#include "engine/picture_denoiser.h"

namespace calotype {

/// Denoises previews as long as that takes little of a render's time.
class PreviewDenoiser {
public:
    /// `denoiser` may be null: then no preview is denoised. It and `features` must outlive this
    /// object. `threads` 0: all cores.
    PreviewDenoiser(const PictureDenoiser* denoiser,
                    const std::optional<DenoiserFeatures>& features, uint32_t threads)
        : denoiser_(denoiser), features_(features), threads_(threads) {}

    /// The picture so far after denoising, without an error; none if denoising took more than a
    /// tenth of `interval` the last time, or if the denoiser needs replicas. `interval`: seconds
    /// since the preview before. The first preview is else always denoised. Throws Error.
    std::optional<CleanPicture> run(const Image& picture, double interval);

private:
    const PictureDenoiser* denoiser_;
    const std::optional<DenoiserFeatures>& features_;
    uint32_t threads_;
    std::optional<double> seconds_; ///< that it took the last time
};

} // namespace calotype
