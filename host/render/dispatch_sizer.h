#pragma once

#include <cstdint>

namespace calotype {

/// Chooses the number of tiles of the next dispatch, so that each takes about a tenth of a second.
/// Drivers end work of more than about two seconds, and the device with it; an interrupt must take
/// effect within one; and much shorter dispatches waste time on their start.
class DispatchSizer {
public:
    static constexpr double kTargetSeconds = 0.1;

    explicit DispatchSizer(uint32_t maxTiles) : maxTiles_(maxTiles) {}

    /// At least 1.
    uint32_t tiles() const { return tiles_; }

    /// Updates the estimate after a dispatch of `tiles` tiles. Grows at most fourfold at a time.
    void update(uint32_t tiles, double seconds);

private:
    uint32_t maxTiles_;
    uint32_t tiles_ = 16;
};

} // namespace calotype
