// Trees of either builder, wide nodes, and what the validator finds wrong with them.
#include <functional>

#include <gtest/gtest.h>

#include "accel/build_bvh.h"
#include "accel/collapse.h"
#include "accel/sah_split.h"
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

/// Each box twice as far out as the one before, which no plane between bins parts well.
std::vector<Primitive> doublingRow(uint32_t count) {
    std::vector<Primitive> row;
    for (uint32_t i = 0; i < count; ++i)
        row.push_back(boxAt({std::ldexp(1.0f, static_cast<int>(i % 200) - 100), 0, 0}, {}));
    return row;
}

struct Input {
    std::string name;
    std::vector<Primitive> primitives;
};

const std::vector<Input>& inputs() {
    static const std::vector<Input> all = {
        {"Nothing", {}},
        {"One", randomBoxes(1)},
        {"TwoKinds", {boxAt({}, {}, PrimitiveKind::Quadric), boxAt({}, {})}},
        {"OneMoreThanALeafHolds", std::vector<Primitive>(Bvh::kMostInLeaf + 1, boxAt({}))},
        {"Nine", randomBoxes(9)},
        {"AThousand", randomBoxes(1000)},
        {"AHundredThousand", randomBoxes(100'000)},
        {"OnePoint", std::vector<Primitive>(1000, boxAt({1, 2, 3}, {}))},
        {"IdenticalBoxes", std::vector<Primitive>(777, boxAt({1, 2, 3}))},
        {"ADoublingRow", doublingRow(1000)},
        {"AFlatRow", [] {
             std::vector<Primitive> row;
             for (int i = 0; i < 500; ++i)
                 row.push_back(boxAt({float(i % 7), 0, 0}, {1, 0, 0}));
             return row;
         }()}};
    return all;
}

class BuiltTreeTest : public testing::TestWithParam<std::tuple<BvhBuilder, size_t>> {
protected:
    const std::vector<Primitive>& primitives_ = inputs()[std::get<1>(GetParam())].primitives;
    BvhBuilder builder_ = std::get<0>(GetParam());
};

TEST_P(BuiltTreeTest, HasNoDefectAndIsAsShallowAsPromised) {
    const Bvh bvh = buildBvh(primitives_, builder_);
    EXPECT_EQ(findBvhDefect(bvh, primitives_), std::nullopt);
    EXPECT_LE(bvh.depth, shared::kMaxBvhDepth);
    const BvhStatistics statistics = bvhStatistics(bvh);
    EXPECT_EQ(statistics.nodes, bvh.nodes.size());
    EXPECT_LE(statistics.nodes, 1 + primitives_.size() / 2);
}

TEST_P(BuiltTreeTest, IsTheSameOnAnyNumberOfThreads) {
    BuildOptions one;
    one.threads = 1;
    BuildOptions several;
    several.threads = 5;
    const Bvh a = buildBvh(primitives_, builder_, one);
    const Bvh b = buildBvh(primitives_, builder_, several);
    EXPECT_EQ(a.order, b.order);
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (size_t i = 0; i < a.nodes.size(); ++i) {
        EXPECT_EQ(a.nodes[i].firstNode, b.nodes[i].firstNode);
        EXPECT_EQ(a.nodes[i].bounds.lower, b.nodes[i].bounds.lower);
        EXPECT_EQ(a.nodes[i].bounds.upper, b.nodes[i].bounds.upper);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, BuiltTreeTest,
                         testing::Combine(testing::Values(BvhBuilder::Median, BvhBuilder::Sah),
                                          testing::Range(size_t{0}, inputs().size())),
                         [](const auto& instance) {
                             const bool isMedian =
                                 std::get<0>(instance.param) == BvhBuilder::Median;
                             return inputs()[std::get<1>(instance.param)].name +
                                    (isMedian ? "ByMedian" : "BySah");
                         });

TEST(BuildBvhTest, BySahVisitsLessThanByMedian) {
    // A wall of small boxes and one floor below all of them.
    std::vector<Primitive> primitives = randomBoxes(5000);
    primitives.push_back(boxAt({-9, -2, -9}, {18, 0, 18}));
    const auto visits = [&](BvhBuilder builder) {
        const BvhStatistics statistics = bvhStatistics(buildBvh(primitives, builder));
        return statistics.nodesVisited + statistics.primitivesVisited;
    };
    EXPECT_LT(visits(BvhBuilder::Sah), 0.8 * visits(BvhBuilder::Median));
}

TEST(BuildBvhTest, ReportsProgressAndCanBeEnded) {
    const std::vector<Primitive> primitives = randomBoxes(200'000);
    BuildOptions options;
    double last = 0.0;
    options.onProgress = [&](double done) {
        EXPECT_LE(done, 1.0);
        last = done;
    };
    buildBvh(primitives, BvhBuilder::Sah, options);
    EXPECT_EQ(last, 1.0);
    struct Ended {};
    options.onProgress = [](double) { throw Ended(); };
    EXPECT_THROW(buildBvh(primitives, BvhBuilder::Sah, options), Ended);
}

// The cost that collapse makes least, against every way of joining a small tree.
class EveryCollapse {
public:
    explicit EveryCollapse(const BinaryTree& tree) : tree_(tree) {}

    /// Of the node as one child.
    double leastCost(uint32_t node) const {
        const BinaryTree::Node& binary = tree_.nodes[node];
        const double asLeaf =
            binary.count <= Bvh::kMostInLeaf ? binary.count * halfArea(binary.bounds) : 1e30;
        if (binary.isLeaf())
            return asLeaf;
        return std::min(asLeaf, kNodeCost * halfArea(binary.bounds) + leastOfForests(node, 8));
    }

private:
    /// Of all ways to hang what is below an inner node from at most `roots` children.
    double leastOfForests(uint32_t node, uint32_t roots) const {
        double least = 1e30;
        for (uint32_t left = 1; left < roots; ++left)
            least = std::min(least, leastOf(BinaryTree::leftOf(node), left) +
                                        leastOf(tree_.rightOf(node), roots - left));
        return least;
    }

    double leastOf(uint32_t node, uint32_t roots) const {
        const double alone = leastCost(node);
        return roots == 1 || tree_.nodes[node].isLeaf()
                   ? alone
                   : std::min(alone, leastOfForests(node, roots));
    }

    const BinaryTree& tree_;
};

TEST(CollapseTest, CostsTheLeastThatItCan) {
    for (const uint32_t count : {2u, 5u, 9u, 14u}) {
        std::vector<Primitive> primitives = randomBoxes(count);
        for (Primitive& primitive : primitives)
            primitive.kind = PrimitiveKind::Triangle;
        const BinaryTree tree = buildSahSplit(primitives);
        const BvhStatistics statistics = bvhStatistics(collapse(tree, primitives, 1));
        const double cost = (kNodeCost * statistics.nodesVisited + statistics.primitivesVisited) *
                            halfArea(tree.nodes[0].bounds);
        const bool isLeafAlone = statistics.nodes == 1 && statistics.leaves == 1;
        const double least = EveryCollapse(tree).leastCost(0) +
                             (isLeafAlone ? kNodeCost * halfArea(tree.nodes[0].bounds) : 0.0);
        EXPECT_NEAR(cost, least, 1e-5 * least) << count;
    }
}

/// A root with a leaf of two boxes and a node that holds two leaves of one.
struct SmallTree {
    std::vector<Primitive> primitives;
    Bvh bvh;

    SmallTree() {
        for (const float x : {0.0f, 1.0f, 2.0f, 3.0f})
            primitives.push_back(boxAt({x, 0, 0}, glm::vec3(1.0f)));
        const Bounds3f left{{0, 0, 0}, {2, 1, 1}};
        const Bounds3f right{{2, 0, 0}, {4, 1, 1}};
        bvh.nodes.resize(2);
        bvh.nodes[0] = {{{0, 0, 0}, {4, 1, 1}}, 1, 0, {}};
        bvh.nodes[0].slots[1] = {left, Bvh::SlotKind::Triangles, 2};
        bvh.nodes[0].slots[4] = {right, Bvh::SlotKind::Node, 0};
        bvh.nodes[1] = {right, 2, 2, {}};
        bvh.nodes[1].slots[0] = {primitives[2].bounds, Bvh::SlotKind::Triangles, 1};
        bvh.nodes[1].slots[7] = {primitives[3].bounds, Bvh::SlotKind::Triangles, 1};
        bvh.order = {0, 1, 2, 3};
        bvh.depth = 1;
    }
};

TEST(BvhStatisticsTest, CountAHandMadeTree) {
    const BvhStatistics statistics = bvhStatistics(SmallTree().bvh);
    EXPECT_EQ(statistics.nodes, 2u);
    EXPECT_EQ(statistics.leaves, 3u);
    EXPECT_DOUBLE_EQ(statistics.childrenPerNode, 2.0);
    EXPECT_DOUBLE_EQ(statistics.primitivesPerLeaf, 4.0 / 3.0);
    // Half areas 9 (root), 5 (either half) and 3 (one box).
    EXPECT_DOUBLE_EQ(statistics.nodesVisited, 1.0 + 5.0 / 9.0);
    EXPECT_DOUBLE_EQ(statistics.primitivesVisited, 2.0 * 5.0 / 9.0 + 2.0 * 3.0 / 9.0);
    EXPECT_EQ(statistics.quadricsVisited, 0.0);
    EXPECT_EQ(bvhStatistics({}).nodes, 0u);
}

TEST(BvhStatisticsTest, CountQuadricsApart) {
    Bvh bvh = SmallTree().bvh;
    bvh.nodes[1].slots[7].kind = Bvh::SlotKind::Quadrics;
    EXPECT_DOUBLE_EQ(bvhStatistics(bvh).quadricsVisited, 3.0 / 9.0);
    EXPECT_DOUBLE_EQ(bvhStatistics(bvh).primitivesVisited,
                     bvhStatistics(SmallTree().bvh).primitivesVisited);
}

struct Defect {
    std::string name;
    std::string message; ///< part of it
    std::function<void(SmallTree&)> plant;
};

class PlantedDefectTest : public testing::TestWithParam<Defect> {};

TEST_P(PlantedDefectTest, IsFound) {
    SmallTree tree;
    ASSERT_EQ(findBvhDefect(tree.bvh, tree.primitives), std::nullopt);
    GetParam().plant(tree);
    const auto defect = findBvhDefect(tree.bvh, tree.primitives);
    ASSERT_TRUE(defect);
    EXPECT_NE(defect->find(GetParam().message), std::string::npos) << *defect;
}

INSTANTIATE_TEST_SUITE_P(
    Of, PlantedDefectTest,
    testing::Values(
        Defect{"FewerPrimitives", "as many", [](SmallTree& tree) { tree.bvh.order.pop_back(); }},
        Defect{"NoNodes", "no nodes", [](SmallTree& tree) { tree.bvh.nodes.clear(); }},
        Defect{"NodesWithoutPrimitives", "empty scene",
               [](SmallTree& tree) {
                   tree.bvh.order.clear();
                   tree.primitives.clear();
               }},
        Defect{"SmallLeafBox", "contain its primitives",
               [](SmallTree& tree) { tree.bvh.nodes[0].slots[1].bounds.upper.x = 1.9f; }},
        Defect{"SmallNodeBox", "contain its children",
               [](SmallTree& tree) { tree.bvh.nodes[0].bounds.lower.y = 0.1f; }},
        Defect{"SmallSlotBox", "contain its node",
               [](SmallTree& tree) { tree.bvh.nodes[0].slots[4].bounds.upper.x = 3.9f; }},
        Defect{"SharedPrimitive", "another leaf", [](SmallTree& tree) { tree.bvh.order[3] = 2; }},
        Defect{"UnknownPrimitive", "does not exist",
               [](SmallTree& tree) { tree.bvh.order[3] = 4; }},
        Defect{"LeafBeyondTheEnd", "beyond",
               [](SmallTree& tree) { tree.bvh.nodes[1].firstPrimitive = 4; }},
        Defect{"LeafFarBeyondTheEnd", "beyond",
               [](SmallTree& tree) { tree.bvh.nodes[1].firstPrimitive = ~0u; }},
        Defect{"LargeLeaf", "too many",
               [](SmallTree& tree) { tree.bvh.nodes[0].slots[1].count = 4; }},
        Defect{"EmptyLeaf", "too few",
               [](SmallTree& tree) { tree.bvh.nodes[0].slots[1].count = 0; }},
        Defect{"MixedLeaf", "mixed",
               [](SmallTree& tree) { tree.primitives[0].kind = PrimitiveKind::Quadric; }},
        Defect{"ForgottenPrimitive", "in no leaf",
               [](SmallTree& tree) { tree.bvh.nodes[1].slots[7] = {}; }},
        Defect{"Cycle", "two parents",
               [](SmallTree& tree) {
                   tree.bvh.nodes[1].slots[3] = {tree.bvh.nodes[1].bounds, Bvh::SlotKind::Node, 0};
                   tree.bvh.nodes[1].firstNode = 1;
               }},
        Defect{"ChildBeyondTheEnd", "does not exist",
               [](SmallTree& tree) { tree.bvh.nodes[0].firstNode = 2; }},
        Defect{"UnreachableNode", "cannot be reached",
               [](SmallTree& tree) { tree.bvh.nodes.push_back(tree.bvh.nodes[1]); }},
        Defect{"WrongDepth", "depth", [](SmallTree& tree) { tree.bvh.depth = 2; }}),
    [](const auto& instance) { return instance.param.name; });

TEST(QuickestBuilderTest, IsMedianForFewPathsOnly) {
    EXPECT_EQ(quickestBuilder(786'000, 512 * 512), BvhBuilder::Median);
    EXPECT_EQ(quickestBuilder(786'000, 512 * 512 * 4), BvhBuilder::Sah);
    EXPECT_EQ(quickestBuilder(12, 64 * 64), BvhBuilder::Sah);
}

} // namespace
} // namespace calotype::test
