// Where the nodes of a tree lie: a child's place is its parent's base and its slot, and no two
// nodes share one.
#include <gtest/gtest.h>

#include <set>

#include "pack/place_nodes.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

/// Nodes in order of depth, each slot of which holds a node with the given probability.
Bvh randomTree(size_t nodes, double probability, RandomNumbers& random) {
    Bvh bvh;
    bvh.nodes.emplace_back();
    for (size_t i = 0; i < bvh.nodes.size() && bvh.nodes.size() < nodes; ++i) {
        const auto firstNode = static_cast<uint32_t>(bvh.nodes.size());
        uint32_t children = 0;
        std::array<Bvh::Slot, Bvh::kSlots> slots;
        for (Bvh::Slot& slot : slots) {
            if (random.unit() < probability) {
                slot.kind = Bvh::SlotKind::Node;
                ++children;
            }
        }
        if (children == 0 && firstNode == i + 1) { // so that the tree does not end here
            slots[i % Bvh::kSlots].kind = Bvh::SlotKind::Node;
            children = 1;
        }
        bvh.nodes[i].slots = slots;
        bvh.nodes[i].firstNode = firstNode;
        bvh.nodes.resize(firstNode + children);
    }
    return bvh;
}

void expectPlacesToFollow(const Bvh& bvh, const NodePlaces& places) {
    std::set<uint32_t> taken = {places.ofNode[0]};
    ASSERT_EQ(places.ofNode[0], 0u);
    for (size_t i = 0; i < bvh.nodes.size(); ++i) {
        uint32_t child = bvh.nodes[i].firstNode;
        for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot) {
            if (bvh.nodes[i].slots[slot].kind != Bvh::SlotKind::Node)
                continue;
            ASSERT_EQ(places.ofNode[child], places.baseOfChildren[i] + slot);
            ASSERT_TRUE(taken.insert(places.ofNode[child++]).second) << "shared by two";
        }
    }
    ASSERT_EQ(taken.size(), bvh.nodes.size());
    EXPECT_EQ(*taken.rbegin() + 1, places.end);
}

TEST(PlaceNodesTest, FollowFromParentAndSlot) {
    RandomNumbers random(81);
    for (const double probability : {0.05, 0.2, 0.5, 0.9, 1.0}) {
        for (const size_t nodes : {1, 2, 9, 100, 5000}) {
            const Bvh bvh = randomTree(nodes, probability, random);
            expectPlacesToFollow(bvh, placeNodes(bvh));
        }
    }
}

// Families that did not interlock would leave four of five places empty at a fifth of the slots.
// A random mask of half the slots is the worst, with 17 % seen; a mesh of 786,000 triangles has 3
// %.
TEST(PlaceNodesTest, LeavesFewPlacesEmpty) {
    RandomNumbers random(82);
    for (const double probability : {0.2, 0.3, 0.5, 0.9}) {
        const Bvh bvh = randomTree(20000, probability, random);
        EXPECT_LE(placeNodes(bvh).end, 1.25 * static_cast<double>(bvh.nodes.size())) << probability;
    }
}

TEST(PlaceNodesTest, OfNoTreeIsNothing) { EXPECT_EQ(placeNodes({}).end, 0u); }

} // namespace
} // namespace calotype::test
