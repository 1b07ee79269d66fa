#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "denoise/denoiser.h"
#include "denoise/oidn_library.h"
#include "image/denoiser_features.h"

namespace calotype {

/// Open Image Denoise on the CPU, so that equal pictures give equal bits on one machine.
class OidnDenoiser : public Denoiser {
public:
    /// About the memory that the library takes for its network, in MiB; larger pictures go through
    /// it in tiles, which overlap by what a pixel can depend on. Always the same, so that pictures
    /// do not depend on the memory that is free.
    static constexpr int kMostMegabytes = 1024;

    /// `typical` is a picture of the scene, of the size of all: its brightness scales all pictures
    /// alike, where the library would scale each by its own. Without features, edges that the noise
    /// hides are lost; null: none. `threads` 0: all cores. The library and the features must
    /// outlive this object. Throws Error if its device or filter cannot be made.
    OidnDenoiser(const OidnLibrary& library, const DenoiserFeatures* features, const Image& typical,
                 uint32_t threads);

    /// "Open Image Denoise 2.5.1".
    std::string name() const override { return name_; }

    /// Of the picture, only the colour matters.
    Image run(const NoisyImage& noisy) override;

private:
    void throwIfFailed() const;
    void setImage(const char* name, const Image& image);

    const OidnLibrary& library_;
    Image color_;
    Image output_;
    std::unique_ptr<OidnLibrary::Device, void (*)(OidnLibrary::Device*)> device_{nullptr, nullptr};
    std::unique_ptr<OidnLibrary::Filter, void (*)(OidnLibrary::Filter*)> filter_{nullptr, nullptr};
    std::string name_;
};

/// The factor by which radiance is multiplied before it is denoised: 0.18 over the geometric mean
/// of the luminance of blocks of 16 x 16 pixels; blocks that are almost black do not count. 1 if
/// all are.
float exposureFor(const Image& picture);

} // namespace calotype
