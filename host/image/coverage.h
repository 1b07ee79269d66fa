#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace calotype {

/// Which share of each pixel shows each of several things, such as the objects of a scene: of the
/// rays through the pixel, all of which have the same weight. Things are numbered from 0.
class Coverage {
public:
    struct Share {
        uint32_t thing = 0;
        float share = 0.0f; ///< of the pixel's rays, in (0, 1]
    };

    /// Of nothing, in `pixels` pixels.
    explicit Coverage(size_t pixels = 0) : entries_(pixels) {}

    /// Adds a ray of each pixel. `primitives` has the primitive that it shows, or kNoPrimitive;
    /// `thingOf` has the thing that each primitive belongs to.
    void addRay(std::span<const uint32_t> primitives, std::span<const uint32_t> thingOf);

    size_t pixelCount() const { return pixelCount_; }

    /// What the pixel shows, the largest share first, and equal ones by their number.
    std::vector<Share> ranked(size_t pixel) const;

private:
    /// Entries of a pixel are a list, whose first one has the pixel's number.
    struct Entry {
        uint32_t thing = 0;
        uint32_t rays = 0; ///< 0: the list is empty
        uint32_t next = kLast;
    };
    static constexpr uint32_t kLast = ~0u;

    void add(uint32_t pixel, uint32_t thing);

    std::vector<Entry> entries_;
    size_t pixelCount_ = entries_.size();
    uint32_t rays_ = 0; ///< of each pixel
};

} // namespace calotype
