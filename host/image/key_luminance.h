#pragma once

#include "image/image.h"

namespace calotype {

/// The luminance of middle grey, as a share of white.
inline constexpr double kMiddleGrey = 0.18;

/// The geometric mean of a picture's luminance, W/(m^2 sr) (Reinhard, Stark, Shirley, Ferwerda
/// 2002, section 3.1), over blocks of 16 x 16 pixels: the mean of a block has little noise, while
/// most pixels of a noisy picture can be black. Blocks below a millionth of the median of those
/// with light do not count. 0 for a black picture.
double keyLuminance(const Image& picture);

} // namespace calotype
