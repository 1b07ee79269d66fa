#include "film/block_ranges.h"

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace calotype::test {
namespace {

std::vector<BlockRange> rangesOf(const BlockRanges& blocks) {
    return {blocks.ranges().begin(), blocks.ranges().end()};
}

BlockRanges make(const std::vector<BlockRange>& ranges) {
    BlockRanges blocks;
    for (const BlockRange& range : ranges)
        blocks.add(range);
    return blocks;
}

TEST(BlockRangesTest, JoinsNeighbours) {
    BlockRanges blocks = make({{4, 6}, {0, 2}, {8, 9}});
    EXPECT_EQ(rangesOf(blocks), (std::vector<BlockRange>{{0, 2}, {4, 6}, {8, 9}}));
    blocks.add({2, 4});
    EXPECT_EQ(rangesOf(blocks), (std::vector<BlockRange>{{0, 6}, {8, 9}}));
    blocks.add(make({{6, 8}, {9, 20}}));
    EXPECT_EQ(rangesOf(blocks), (std::vector<BlockRange>{{0, 20}}));
}

// The same set in any order gives the same ranges, and all their functions return what a plain set
// does.
TEST(BlockRangesTest, AgreesWithAPlainSet) {
    std::mt19937 random(5);
    for (int round = 0; round < 200; ++round) {
        std::set<uint32_t> plain;
        for (uint32_t block = 0; block < 40; ++block)
            if (random() % 3 != 0)
                plain.insert(block);
        std::vector<uint32_t> order(plain.begin(), plain.end());
        std::shuffle(order.begin(), order.end(), random);
        BlockRanges blocks;
        for (const uint32_t block : order)
            blocks.add({block, block + 1});
        BlockRanges ascending;
        for (const uint32_t block : plain)
            ascending.add({block, block + 1});
        ASSERT_EQ(blocks, ascending);
        ASSERT_EQ(blocks.count(), plain.size());
        for (uint32_t residue = 0; residue < 8; ++residue)
            ASSERT_EQ(blocks.countOf(residue, 8),
                      static_cast<size_t>(std::ranges::count_if(
                          plain, [&](uint32_t block) { return block % 8 == residue; })));
        const auto begin = static_cast<uint32_t>(random() % 40);
        const auto end = begin + 1 + static_cast<uint32_t>(random() % 20);
        BlockRanges missing;
        for (uint32_t block = begin; block < end; ++block)
            if (!plain.contains(block))
                missing.add({block, block + 1});
        ASSERT_EQ(blocks.missingFrom({begin, end}), missing);
        const BlockRange both = blocks.firstOverlap(make({{begin, end}}));
        const auto first = plain.lower_bound(begin);
        if (first == plain.end() || *first >= end)
            ASSERT_EQ(both, BlockRange{});
        else
            ASSERT_EQ(both.begin, *first);
    }
}

TEST(BlockRangesTest, NamesWhatItLacksOfOthers) {
    const BlockRanges blocks = make({{2, 4}, {6, 8}});
    EXPECT_EQ(blocks.missingFrom(make({{0, 3}, {5, 9}})), make({{0, 2}, {5, 6}, {8, 9}}));
    EXPECT_TRUE(blocks.missingFrom(blocks).empty());
    EXPECT_TRUE(blocks.missingFrom(make({})).empty());
}

TEST(BlockRangesTest, NamesItsGaps) {
    EXPECT_TRUE(make({}).gaps().empty());
    EXPECT_TRUE(make({{2, 4}}).gaps().empty()) << "nothing is said of what is before the first";
    EXPECT_EQ(make({{0, 2}, {4, 5}, {7, 9}}).gaps(), make({{2, 4}, {5, 7}}));
    EXPECT_EQ(sampleText(make({{0, 2}, {4, 5}})), "0:32, 64:80");
    EXPECT_EQ(sampleText(make({})), "");
}

TEST(BlockRangesDeathTest, RefusesWhatItHolds) {
    BlockRanges blocks = make({{2, 4}});
    EXPECT_DEATH(blocks.add({3, 5}), "check failed");
    EXPECT_DEATH(blocks.add({0, 3}), "check failed");
    EXPECT_DEATH(blocks.add({2, 4}), "check failed");
    EXPECT_DEATH(blocks.add({5, 5}), "check failed");
}

} // namespace
} // namespace calotype::test
