#include "image/coverage.h"

#include <algorithm>

#include "base/check.h"
#include "image/first_hit.h"

namespace calotype {

void Coverage::addRay(std::span<const uint32_t> primitives, std::span<const uint32_t> thingOf) {
    CALOTYPE_CHECK_EQ(primitives.size(), pixelCount_);
    for (uint32_t pixel = 0; pixel < primitives.size(); ++pixel)
        if (primitives[pixel] != kNoPrimitive) {
            CALOTYPE_CHECK_LT(primitives[pixel], thingOf.size());
            add(pixel, thingOf[primitives[pixel]]);
        }
    ++rays_;
}

void Coverage::add(uint32_t pixel, uint32_t thing) {
    uint32_t at = pixel;
    while (entries_[at].rays > 0 && entries_[at].thing != thing && entries_[at].next != kLast)
        at = entries_[at].next;
    if (entries_[at].rays > 0 && entries_[at].thing != thing) {
        const auto added = static_cast<uint32_t>(entries_.size());
        entries_[at].next = added;
        entries_.push_back({});
        at = added;
    }
    entries_[at].thing = thing;
    ++entries_[at].rays;
}

std::vector<Coverage::Share> Coverage::ranked(size_t pixel) const {
    std::vector<Share> shares;
    for (auto at = static_cast<uint32_t>(pixel); at != kLast; at = entries_[at].next)
        if (entries_[at].rays > 0)
            shares.push_back({entries_[at].thing,
                              static_cast<float>(entries_[at].rays) / static_cast<float>(rays_)});
    std::ranges::sort(shares, [](const Share& a, const Share& b) {
        return a.share != b.share ? a.share > b.share : a.thing < b.thing;
    });
    return shares;
}

} // namespace calotype
