#include <functional>

#include <gtest/gtest.h>

#include "accel/bvh.h"
#include "accel/median_split.h"
#include "shared/limits.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

Primitive boxAt(const glm::vec3& lower, const glm::vec3& size = glm::vec3(0.1f),
                PrimitiveKind kind = PrimitiveKind::Triangle) {
    return {{lower, lower + size}, 0, 0, kind};
}

std::vector<Primitive> randomBoxes(uint32_t count) {
    RandomNumbers random(count);
    std::vector<Primitive> primitives;
    for (uint32_t i = 0; i < count; ++i)
        primitives.push_back(
            boxAt(glm::vec3(random.inBall()), glm::vec3(0.01f),
                  random.below(4) == 0 ? PrimitiveKind::Quadric : PrimitiveKind::Triangle));
    return primitives;
}

struct Input {
    std::string name;
    std::vector<Primitive> primitives;
};

class BuiltTree : public testing::TestWithParam<Input> {};

TEST_P(BuiltTree, HasNoDefectAndIsAsShallowAsPromised) {
    const std::vector<Primitive>& primitives = GetParam().primitives;
    const Bvh bvh = buildMedianSplit(primitives);
    EXPECT_EQ(findBvhDefect(bvh, primitives), std::nullopt);
    const BvhStatistics statistics = bvhStatistics(bvh);
    EXPECT_EQ(statistics.nodes, bvh.nodes.size());
    if (!primitives.empty()) {
        EXPECT_EQ(statistics.nodes, 2 * statistics.leaves - 1);
        EXPECT_LE(statistics.depth, std::log2(double(primitives.size())) + 2.0);
        EXPECT_LE(statistics.primitivesPerLeaf, gpu::kMaxLeafPrimitives);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, BuiltTree,
    testing::Values(
        Input{"Nothing", {}}, Input{"One", randomBoxes(1)},
        Input{"TwoKinds", {boxAt({}, {}, PrimitiveKind::Quadric), boxAt({}, {})}},
        Input{"OneMoreThanALeafHolds",
              std::vector<Primitive>(gpu::kMaxLeafPrimitives + 1, boxAt({}))},
        Input{"Five", randomBoxes(5)}, Input{"AThousand", randomBoxes(1000)},
        Input{"AHundredThousand", randomBoxes(100'000)},
        Input{"OnePoint", std::vector<Primitive>(1000, boxAt({1, 2, 3}, {}))},
        Input{"IdenticalBoxes", std::vector<Primitive>(777, boxAt({1, 2, 3}))},
        Input{
            "AFlatRow",
            [] {
                std::vector<Primitive> row;
                for (int i = 0; i < 500; ++i)
                    row.push_back(boxAt({float(i % 7), 0, 0}, {1, 0, 0}));
                return row;
            }()}),
    [](const auto& instance) { return instance.param.name; });

/// Two leaves of two boxes along x.
struct SmallTree {
    std::vector<Primitive> primitives;
    Bvh bvh;

    SmallTree() {
        for (const float x : {0.0f, 1.0f, 2.0f, 3.0f})
            primitives.push_back(boxAt({x, 0, 0}, glm::vec3(1.0f)));
        bvh.nodes = {{{{0, 0, 0}, {4, 1, 1}}, 1, 0},
                     {{{0, 0, 0}, {2, 1, 1}}, 0, 2},
                     {{{2, 0, 0}, {4, 1, 1}}, 2, 2}};
        bvh.order = {0, 1, 2, 3};
    }
};

TEST(BvhStatistics, CountAHandMadeTree) {
    const BvhStatistics statistics = bvhStatistics(SmallTree().bvh);
    EXPECT_EQ(statistics.nodes, 3u);
    EXPECT_EQ(statistics.leaves, 2u);
    EXPECT_EQ(statistics.depth, 1u);
    EXPECT_DOUBLE_EQ(statistics.primitivesPerLeaf, 2.0);
    // Half areas 9 (root) and 5 (leaves): two boxes always, two primitives with chance 5/9, twice.
    EXPECT_DOUBLE_EQ(statistics.sahCost, 2.0 + 2.0 * 2.0 * 5.0 / 9.0);
    EXPECT_EQ(bvhStatistics({}).nodes, 0u);
}

struct Defect {
    std::string name;
    std::string message; ///< part of it
    std::function<void(SmallTree&)> plant;
};

class PlantedDefect : public testing::TestWithParam<Defect> {};

TEST_P(PlantedDefect, IsFound) {
    SmallTree tree;
    ASSERT_EQ(findBvhDefect(tree.bvh, tree.primitives), std::nullopt);
    GetParam().plant(tree);
    const auto defect = findBvhDefect(tree.bvh, tree.primitives);
    ASSERT_TRUE(defect);
    EXPECT_NE(defect->find(GetParam().message), std::string::npos) << *defect;
}

void growChain(SmallTree& tree) {
    // Inner nodes, each the left child of the last, one more than fits.
    tree.bvh.nodes = {{{{0, 0, 0}, {4, 1, 1}}, 1, 0}};
    for (uint32_t depth = 0; depth <= gpu::kMaxBvhDepth; ++depth) {
        const auto next = static_cast<uint32_t>(tree.bvh.nodes.size());
        tree.bvh.nodes.push_back({{{0, 0, 0}, {4, 1, 1}}, next + 2, 0});
        tree.bvh.nodes.push_back({{{0, 0, 0}, {1, 1, 1}}, 0, 1});
    }
    tree.bvh.nodes.push_back({{{0, 0, 0}, {1, 1, 1}}, 0, 1});
    tree.bvh.nodes.push_back({{{0, 0, 0}, {1, 1, 1}}, 0, 1});
}

INSTANTIATE_TEST_SUITE_P(
    Of, PlantedDefect,
    testing::Values(
        Defect{"FewerPrimitives", "as many", [](SmallTree& tree) { tree.bvh.order.pop_back(); }},
        Defect{"NoNodes", "no nodes", [](SmallTree& tree) { tree.bvh.nodes.clear(); }},
        Defect{"NodesWithoutPrimitives", "empty scene",
               [](SmallTree& tree) {
                   tree.bvh.order.clear();
                   tree.primitives.clear();
               }},
        Defect{"SmallLeafBox", "contain its primitives",
               [](SmallTree& tree) { tree.bvh.nodes[1].bounds.upper.x = 1.9f; }},
        Defect{"SmallRootBox", "contain its children",
               [](SmallTree& tree) { tree.bvh.nodes[0].bounds.lower.y = 0.1f; }},
        Defect{"SharedPrimitive", "another leaf", [](SmallTree& tree) { tree.bvh.order[3] = 2; }},
        Defect{"UnknownPrimitive", "does not exist",
               [](SmallTree& tree) { tree.bvh.order[3] = 4; }},
        Defect{"LeafBeyondTheEnd", "beyond", [](SmallTree& tree) { tree.bvh.nodes[2].count = 3; }},
        Defect{"LeafFarBeyondTheEnd", "beyond",
               [](SmallTree& tree) { tree.bvh.nodes[2].first = ~0u; }},
        Defect{"LargeLeaf", "too many", [](SmallTree& tree) { tree.bvh.nodes[1].count = 5; }},
        Defect{"MixedLeaf", "mixes",
               [](SmallTree& tree) { tree.primitives[0].kind = PrimitiveKind::Quadric; }},
        Defect{"ForgottenPrimitive", "in no leaf",
               [](SmallTree& tree) { tree.bvh.nodes[2].count = 1; }},
        Defect{"Cycle", "do not exist",
               [](SmallTree& tree) {
                   tree.bvh.nodes[2] = {tree.bvh.nodes[0].bounds, 0, 0};
               }},
        Defect{"TwoParents", "two parents",
               [](SmallTree& tree) {
                   for (Bvh::Node& node : tree.bvh.nodes)
                       node.bounds = tree.bvh.nodes[0].bounds;
                   tree.bvh.nodes[2].first = 1;
                   tree.bvh.nodes[2].count = 0;
               }},
        Defect{"ChildrenBeyondTheEnd", "do not exist",
               [](SmallTree& tree) { tree.bvh.nodes[0].first = 2; }},
        Defect{"UnreachableNode", "cannot be reached",
               [](SmallTree& tree) { tree.bvh.nodes.push_back(tree.bvh.nodes[2]); }},
        Defect{"LongChain", "too deep", growChain}),
    [](const auto& instance) { return instance.param.name; });

} // namespace
} // namespace calotype::test
