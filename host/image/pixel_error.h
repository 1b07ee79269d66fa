#pragma once

namespace calotype {

/// Estimates of the error of one pixel's luminance, W/(m^2 sr). Both are infinite if the samples
/// are too few.
struct PixelError {
    float standardError = 0.0f;
    float interval = 0.0f; ///< half the width of the 95 % confidence interval
};

} // namespace calotype
