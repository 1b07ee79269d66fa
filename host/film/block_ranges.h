#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace calotype {

/// Consecutive blocks of samples, from `begin` up to but not including `end`; not empty.
struct BlockRange {
    uint32_t begin = 0;
    uint32_t end = 0;

    auto operator<=>(const BlockRange&) const = default;
};

/// "32:64": the absolute indices of the samples, as --samples takes them.
std::string sampleText(const BlockRange& range);

/// A set of blocks, as the fewest ranges, in ascending order. The same set always has the same
/// ranges, in whatever order its blocks were added.
class BlockRanges {
public:
    BlockRanges() = default;

    /// Adds blocks, none of which are in the set yet.
    void add(BlockRange range);
    void add(const BlockRanges& others);

    std::span<const BlockRange> ranges() const& { return ranges_; }
    std::span<const BlockRange> ranges() const&& = delete;
    bool empty() const { return ranges_.empty(); }
    uint64_t count() const;

    /// The number of blocks with that residue modulo `divisor`.
    uint64_t countOf(uint32_t residue, uint32_t divisor) const;

    /// The first range of blocks that are in both sets; 0 to 0 where there is none.
    BlockRange firstOverlap(const BlockRanges& others) const;

    /// The blocks of `range`, or of `others`, that are not in the set.
    BlockRanges missingFrom(BlockRange range) const;
    BlockRanges missingFrom(const BlockRanges& others) const;

    /// The blocks between the first and the last one of the set that are not in it.
    BlockRanges gaps() const;

    bool operator==(const BlockRanges&) const = default;

private:
    std::vector<BlockRange> ranges_;
};

/// "0:32, 64:80"; empty for no blocks.
std::string sampleText(const BlockRanges& blocks);

} // namespace calotype
