#pragma once

namespace calotype {

/// How far one pixel's luminance may be from what it would become with endless samples, W/(m^2 sr).
/// Both are infinite where there are too few samples to tell.
struct PixelError {
    float standardError = 0.0f;
    float interval = 0.0f; ///< half the width of the 95 % confidence interval
};

} // namespace calotype
