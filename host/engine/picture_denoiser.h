#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "denoise/cross_validation.h"
#include "denoise/film_view.h"
#include "denoise/oidn_library.h"
#include "engine/clean_picture.h"
#include "engine/device_session.h"
#include "image/denoiser_features.h"
#include "settings/denoiser_kind.h"

namespace calotype {

/// Denoises pictures by the denoiser that the settings name.
class PictureDenoiser {
public:
    using OnProgress = std::function<void(double)>;

    /// Loads what the denoiser needs from DeviceOptions::denoiserLibrary. Throws SettingError with
    /// what to do if it is not there. The statistical denoiser runs on `device`, which `run` opens,
    /// and which must outlive this object; null, or the reference: in double precision on the CPU.
    PictureDenoiser(DenoiserKind kind, const std::string& library, DeviceKeeper* device = nullptr);

    DenoiserKind kind() const { return kind_; }

    /// Whether it cannot denoise a picture alone.
    bool needsReplicas() const { return kind_ == DenoiserKind::Statistical; }

    /// Why the film has too few samples; empty if it has enough.
    std::string whyTooFewSamples(const FilmView& film) const;

    /// Denoises a film that keeps the colours of replicas. `noisy` is its picture with the samples
    /// of an unfinished block: where the replicas are too few for an error, it is denoised instead,
    /// or returned as it is if whyTooFewSamples says so. `features` are those of the pixels,
    /// if they are known; `threads` 0: all cores. `onProgress` is called with the share done in
    /// [0, 1]; it may throw to end the work. Throws Error.
    CleanPicture run(const FilmView& film, const Image& noisy,
                     const std::optional<DenoiserFeatures>& features, uint32_t threads,
                     const OnProgress& onProgress = {}) const;

    /// Denoises a picture whose pixels are finite, by a denoiser that does not need replicas. No
    /// error is stated.
    CleanPicture run(const Image& noisy, const std::optional<DenoiserFeatures>& features,
                     uint32_t threads) const;

private:
    std::unique_ptr<Denoiser> denoiserFor(const std::optional<DenoiserFeatures>& features,
                                          const Image& typical, uint32_t threads) const;

    DenoiserKind kind_;
    DeviceKeeper* device_;
    std::optional<OidnLibrary> library_; ///< for DenoiserKind::Oidn
};

} // namespace calotype
