#include "render/dispatch_sizer.h"

#include <algorithm>

namespace calotype {

void DispatchSizer::update(uint32_t tiles, double seconds) {
    const double growth = std::min(kTargetSeconds / std::max(seconds, 1e-6), 4.0);
    tiles_ = static_cast<uint32_t>(std::clamp(tiles * growth, 1.0, static_cast<double>(maxTiles_)));
}

} // namespace calotype
