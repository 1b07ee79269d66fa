#include "denoise/oidn_denoiser.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/error.h"
#include "image/key_luminance.h"

namespace calotype {

float exposureFor(const Image& picture) {
    const double key = keyLuminance(picture);
    return key > 0.0 ? static_cast<float>(kMiddleGrey / key) : 1.0f;
}

OidnDenoiser::OidnDenoiser(const OidnLibrary& library, const DenoiserFeatures* features,
                           const Image& typical, uint32_t threads)
    : library_(library), color_(typical.width, typical.height),
      output_(typical.width, typical.height) {
    device_ = {library_.newDevice(OidnLibrary::kCpuDevice), library_.releaseDevice};
    if (!device_)
        throw Error("Open Image Denoise has no device for this CPU");
    if (threads > 0)
        library_.setDeviceInt(device_.get(), "numThreads", static_cast<int>(threads));
    library_.commitDevice(device_.get());
    throwIfFailed();
    const auto number = [&](const char* part) {
        return std::to_string(library_.getDeviceInt(device_.get(), part));
    };
    name_ = "Open Image Denoise " + number("versionMajor") + "." + number("versionMinor") + "." +
            number("versionPatch");
    filter_ = {library_.newFilter(device_.get(), "RT"), library_.releaseFilter};
    throwIfFailed();
    setImage("color", color_);
    if (features) {
        setImage("albedo", features->albedo);
        setImage("normal", features->normal);
        library_.setFilterBool(filter_.get(), "cleanAux", features->areMeans);
    }
    setImage("output", output_);
    library_.setFilterBool(filter_.get(), "hdr", true);
    library_.setFilterInt(filter_.get(), "quality", OidnLibrary::kHighQuality);
    library_.setFilterInt(filter_.get(), "maxMemoryMB", kMostMegabytes);
    library_.setFilterFloat(filter_.get(), "inputScale", exposureFor(typical));
    library_.commitFilter(filter_.get());
    throwIfFailed();
}

/// The library reads and writes the pixels in place.
void OidnDenoiser::setImage(const char* name, const Image& image) {
    CALOTYPE_CHECK_EQ(image.width, color_.width);
    CALOTYPE_CHECK_EQ(image.height, color_.height);
    library_.setSharedFilterImage(filter_.get(), name, const_cast<glm::vec3*>(image.pixels.data()),
                                  OidnLibrary::kFloat3, image.width, image.height, 0, 0, 0);
}

Image OidnDenoiser::run(const NoisyImage& noisy) {
    CALOTYPE_CHECK_EQ(noisy.color.width, color_.width);
    CALOTYPE_CHECK_EQ(noisy.color.height, color_.height);
    std::ranges::copy(noisy.color.pixels, color_.pixels.begin());
    library_.executeFilter(filter_.get());
    throwIfFailed();
    return output_;
}

void OidnDenoiser::throwIfFailed() const {
    const char* message = nullptr;
    if (library_.getDeviceError(device_.get(), &message) != OidnLibrary::kNoError)
        throw Error("Open Image Denoise failed: " + std::string(message ? message : "no reason"));
}

} // namespace calotype
