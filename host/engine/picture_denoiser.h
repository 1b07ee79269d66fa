#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "denoise/cross_validation.h"
#include "denoise/oidn_library.h"
#include "film/film.h"
#include "image/denoiser_features.h"
#include "settings/denoiser_kind.h"

namespace calotype {

/// A picture after denoising.
struct CleanPicture {
    Image color;
    std::string denoiser; ///< with its version
    std::optional<DenoisedError> error;
    std::string whyUnstated; ///< why there is no error, in words such as "too few samples to tell"
};

/// Denoises pictures by the denoiser that the settings name.
class PictureDenoiser {
public:
    using OnProgress = std::function<void(double)>;

    /// Loads what the denoiser needs from DeviceOptions::denoiserLibrary. Throws SettingError with
    /// what to do if it is not there.
    PictureDenoiser(DenoiserKind kind, const std::string& library);

    /// Denoises a film that keeps the colours of replicas, or `noisy`, its picture with the samples
    /// of an unfinished block, where the replicas are too few. `features` are those of the pixels,
    /// if they are known; `threads` 0: all cores. `onProgress` is called with the share done in
    /// [0, 1]; it may throw to end the work. Throws Error.
    CleanPicture run(const Film& film, const Image& noisy,
                     const std::optional<DenoiserFeatures>& features, uint32_t threads,
                     const OnProgress& onProgress = {}) const;

    /// Denoises a picture whose pixels are finite. No error is stated.
    CleanPicture run(const Image& noisy, const std::optional<DenoiserFeatures>& features,
                     uint32_t threads) const;

private:
    OidnLibrary library_;
};

} // namespace calotype
