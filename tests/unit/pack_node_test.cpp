// Boxes on a node's grid of cells: never smaller than what they hold, and hardly larger.
#include <gtest/gtest.h>

#include <sstream>

#include "pack/pack_node.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

/// Differences of two floats whose exponents differ by up to 88 are exact.
using Exact = __float128;

uint32_t byteOf(const shared::uvec2& words, uint32_t slot) {
    return words[slot / 4] >> (8 * (slot % 4)) & 255u;
}

double cellSize(const shared::BvhNode& node, int axis) {
    return std::ldexp(1.0, static_cast<int>(node.nodesAndExponents >> (8 * axis) & 255u) - 127);
}

/// From the node's origin: so that no sum of a large and a tiny number has to be exact.
struct PackedBox {
    Exact lower[3];
    Exact upper[3];
};

PackedBox boxOf(const shared::BvhNode& node, uint32_t slot) {
    const shared::uvec2 lower[] = {node.lowerX, node.lowerY, node.lowerZ};
    const shared::uvec2 upper[] = {node.upperX, node.upperY, node.upperZ};
    PackedBox box{};
    for (int axis = 0; axis < 3; ++axis) {
        box.lower[axis] = Exact(byteOf(lower[axis], slot)) * Exact(cellSize(node, axis));
        box.upper[axis] = Exact(byteOf(upper[axis], slot)) * Exact(cellSize(node, axis));
    }
    return box;
}

/// Boxes of any place and size within about `size` of `place`; points and slabs among them.
Bvh::Node randomNode(const glm::dvec3& place, double size, RandomNumbers& random) {
    Bvh::Node node;
    for (Bvh::Slot& slot : node.slots) {
        slot.kind = Bvh::SlotKind::Triangles;
        slot.count = 1;
        slot.bounds = {};
        for (int corner = 0; corner < 2; ++corner)
            slot.bounds.extend(glm::vec3(place + size * random.inBall()));
        if (random.below(4) == 0)
            slot.bounds.upper = slot.bounds.lower;
        if (random.below(4) == 0)
            slot.bounds.upper.x = slot.bounds.lower.x;
        node.bounds.extend(slot.bounds);
    }
    return node;
}

void expectToHold(const Bvh::Node& node) {
    const shared::BvhNode packed = packNode(node, {}, 0);
    for (uint32_t slot = 0; slot < Bvh::kSlots; ++slot) {
        const PackedBox box = boxOf(packed, slot);
        for (int axis = 0; axis < 3; ++axis) {
            const Exact origin = packed.origin[axis];
            const Exact lower = Exact(node.slots[slot].bounds.lower[axis]) - origin;
            const Exact upper = Exact(node.slots[slot].bounds.upper[axis]) - origin;
            const Exact cell = cellSize(packed, axis);
            const auto where = [&] {
                std::ostringstream text;
                text << "[" << double(lower) << ", " << double(upper) << "] on a grid from "
                     << double(origin) << " of " << double(cell);
                return text.str();
            };
            ASSERT_TRUE(box.lower[axis] <= lower) << where();
            ASSERT_TRUE(box.upper[axis] >= upper) << where();
            ASSERT_TRUE(box.lower[axis] + cell > lower) << where();
            ASSERT_TRUE(box.upper[axis] - cell < upper) << where();
        }
    }
}

TEST(PackNodeTest, HoldsItsContentsAtAnyScaleAndPlace) {
    RandomNumbers random(71);
    for (int i = 0; i < 20'000; ++i) {
        const double size = random.powerOfTen(-14.0, 12.0);
        const glm::dvec3 direction = random.direction();
        expectToHold(randomNode({}, size, random));
        expectToHold(randomNode(random.powerOfTen(-14.0, 12.0) * direction, size, random));
        // So far away that the boxes are a few roundings large.
        expectToHold(randomNode(size * random.powerOfTen(6.0, 8.0) * direction, size, random));
    }
}

TEST(PackNodeTest, HoldsBoxesThatEndOnCellBoundaries) {
    RandomNumbers random(72);
    for (int i = 0; i < 20'000; ++i) {
        Bvh::Node node = randomNode(random.powerOfTen(-3.0, 3.0) * random.direction(), 1.0, random);
        for (Bvh::Slot& slot : node.slots)
            for (int axis = 0; axis < 3; ++axis) {
                const float cell = std::ldexp(1.0f, -7);
                slot.bounds.lower[axis] = cell * std::floor(slot.bounds.lower[axis] / cell);
                slot.bounds.upper[axis] = cell * std::ceil(slot.bounds.upper[axis] / cell);
                node.bounds.extend(slot.bounds);
            }
        expectToHold(node);
    }
}

TEST(PackNodeTest, UsesMoreThanAQuarterOfItsGrid) {
    RandomNumbers random(73);
    for (int i = 0; i < 1000; ++i) {
        const Bvh::Node node = randomNode({}, random.powerOfTen(-10.0, 10.0), random);
        const shared::BvhNode packed = packNode(node, {}, 0);
        for (int axis = 0; axis < 3; ++axis) {
            const double extent = double{node.bounds.upper[axis]} - node.bounds.lower[axis];
            EXPECT_LE(extent, 255.0 * cellSize(packed, axis));
            EXPECT_GE(extent, 0.249 * 255.0 * cellSize(packed, axis));
        }
    }
}

TEST(PackNodeTest, SaysWhatItsChildrenAre) {
    Bvh::Node node;
    node.bounds = {{0, 0, 0}, {1, 1, 1}};
    node.slots[1] = {node.bounds, Bvh::SlotKind::Triangles, 2};
    node.slots[3] = {node.bounds, Bvh::SlotKind::Node, 0};
    node.slots[6] = {node.bounds, Bvh::SlotKind::Quadrics, 3};
    const shared::BvhNode packed = packNode(node, {5, 9}, 77);
    EXPECT_EQ(packed.childBase, 77u);
    EXPECT_EQ(packed.firstTriangle, 5u);
    EXPECT_EQ(packed.firstQuadric, 9u);
    EXPECT_EQ(packed.nodesAndExponents >> 24, 1u << 3);
    EXPECT_EQ(packed.primitives, (1u << 6) << 24 | 7u << 18 | 3u << 3);
}

} // namespace
} // namespace calotype::test
