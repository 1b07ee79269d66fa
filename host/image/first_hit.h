#pragma once

#include "image/image.h"
#include "shared/layers.h"

namespace calotype {

/// FirstHit::primitive if there is none.
inline constexpr uint32_t kNoPrimitive = ~0u;

/// The surface that a pixel shows. The defaults are a pixel that shows no surface.
using shared::FirstHit;

using FirstHitImage = PixelGrid<FirstHit>;

} // namespace calotype
