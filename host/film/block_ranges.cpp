#include "film/block_ranges.h"

#include <algorithm>

#include "base/check.h"
#include "shared/limits.h"

namespace calotype {
namespace {

BlockRange intersection(const BlockRange& a, const BlockRange& b) {
    const BlockRange both{std::max(a.begin, b.begin), std::min(a.end, b.end)};
    return both.begin < both.end ? both : BlockRange{};
}

} // namespace

std::string sampleText(const BlockRange& range) {
    const auto sample = [](uint32_t block) {
        return std::to_string(block * shared::kSamplesPerBlock);
    };
    return sample(range.begin) + ":" + sample(range.end);
}

void BlockRanges::add(BlockRange range) {
    CALOTYPE_CHECK_LT(range.begin, range.end);
    auto next = std::ranges::lower_bound(ranges_, range);
    if (next != ranges_.end()) {
        CALOTYPE_CHECK_LE(range.end, next->begin);
        if (range.end == next->begin) {
            range.end = next->end;
            next = ranges_.erase(next);
        }
    }
    if (next != ranges_.begin()) {
        BlockRange& previous = *std::prev(next);
        CALOTYPE_CHECK_LE(previous.end, range.begin);
        if (previous.end == range.begin) {
            previous.end = range.end;
            return;
        }
    }
    ranges_.insert(next, range);
}

void BlockRanges::add(const BlockRanges& others) {
    for (const BlockRange& range : others.ranges_)
        add(range);
}

uint64_t BlockRanges::count() const { return countOf(0, 1); }

uint64_t BlockRanges::countOf(uint32_t residue, uint32_t divisor) const {
    CALOTYPE_CHECK_LT(residue, divisor);
    const auto before = [&](uint32_t end) { return (end - residue + divisor - 1) / divisor; };
    uint64_t count = 0;
    for (const BlockRange& range : ranges_)
        count += before(std::max(range.end, residue)) - before(std::max(range.begin, residue));
    return count;
}

BlockRange BlockRanges::firstOverlap(const BlockRanges& others) const {
    auto theirs = others.ranges_.begin();
    for (const BlockRange& mine : ranges_) {
        while (theirs != others.ranges_.end() && theirs->end <= mine.begin)
            ++theirs;
        if (theirs == others.ranges_.end())
            break;
        if (const BlockRange both = intersection(mine, *theirs); both.end > 0)
            return both;
    }
    return {};
}

BlockRanges BlockRanges::missingFrom(BlockRange range) const {
    BlockRanges missing;
    uint32_t begin = range.begin;
    for (const BlockRange& held : ranges_) {
        const BlockRange both = intersection(held, range);
        if (both.end == 0)
            continue;
        if (begin < both.begin)
            missing.add({begin, both.begin});
        begin = both.end;
    }
    if (begin < range.end)
        missing.add({begin, range.end});
    return missing;
}

BlockRanges BlockRanges::missingFrom(const BlockRanges& others) const {
    BlockRanges missing;
    for (const BlockRange& range : others.ranges_)
        missing.add(missingFrom(range));
    return missing;
}

BlockRanges BlockRanges::gaps() const {
    if (empty())
        return {};
    return missingFrom({ranges_.front().begin, ranges_.back().end});
}

std::string sampleText(const BlockRanges& blocks) {
    std::string text;
    for (const BlockRange& range : blocks.ranges())
        text += (text.empty() ? "" : ", ") + sampleText(range);
    return text;
}

} // namespace calotype
