#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "denoise/cross_validation.h"
#include "denoise/oidn_library.h"
#include "film/film.h"
#include "image/features.h"
#include "settings/denoiser_kind.h"

namespace calotype {

/// A picture after denoising.
struct CleanPicture {
    Image color;
    std::string denoiser; ///< with its version
    /// None where the samples are too few, or their own error is not to be trusted: then nobody can
    /// say how wrong the picture is.
    std::optional<DenoisedError> error;
};

/// Denoises pictures of films by the denoiser that the settings name.
class PictureDenoiser {
public:
    /// Loads what the denoiser needs from DeviceOptions::denoiserLibrary. Throws SettingError with
    /// what to do if it is not there.
    PictureDenoiser(DenoiserKind kind, const std::string& library);

    /// Denoises a film that keeps the colours of replicas, or `noisy`, its picture with the samples
    /// of an unfinished block, where the replicas are too few. `features` are those of the pixels;
    /// `threads` 0: all cores. Throws Error.
    CleanPicture run(const Film& film, const Image& noisy, const FeatureImage& features,
                     uint32_t threads) const;

private:
    OidnLibrary library_;
};

} // namespace calotype
