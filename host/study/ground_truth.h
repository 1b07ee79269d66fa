#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.h"
#include "image/pixel_error.h"
#include "render/session.h"

namespace calotype {

/// The picture against which a study measures errors.
struct GroundTruth {
    Image picture;
    std::vector<double> luminances;
    double mean = 0.0;      ///< luminance
    double meanError = 0.0; ///< standard error of that
    double error = 0.0;     ///< ErrorEstimate::relative
    bool isTrusted = false;
    uint64_t samples = 0; ///< per pixel
    double seconds = 0.0;

    /// The session must have at least one block of two replicas.
    explicit GroundTruth(Session& session);

    /// CurvePoint::error of a picture of the same size.
    std::optional<double> errorOf(const Image& image) const;
};

/// Mean luminance of a picture, and its standard error, from those of the pixels.
struct MeanLuminance {
    double mean = 0.0;
    double standardError = 0.0;
};
MeanLuminance meanLuminance(const Image& image, const std::vector<PixelError>& errors);

} // namespace calotype
