#include <gtest/gtest.h>

#include "pack/alias_table.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

/// The probability of each index that the columns add up to.
std::vector<double> chancesOf(const std::vector<AliasColumn>& columns) {
    std::vector<double> chances(columns.size(), 0.0);
    for (size_t i = 0; i < columns.size(); ++i) {
        chances[i] += columns[i].threshold / double(columns.size());
        chances[columns[i].alias] += (1.0 - columns[i].threshold) / double(columns.size());
    }
    return chances;
}

void expectExact(const std::vector<double>& weights) {
    const std::vector<AliasColumn> columns = buildAliasTable(weights);
    double sum = 0.0;
    for (const double weight : weights)
        sum += weight;
    const std::vector<double> chances = chancesOf(columns);
    ASSERT_EQ(columns.size(), weights.size());
    for (size_t i = 0; i < weights.size(); ++i) {
        EXPECT_DOUBLE_EQ(columns[i].chance, weights[i] / sum);
        EXPECT_NEAR(chances[i], weights[i] / sum, 1e-14);
        EXPECT_GE(columns[i].threshold, 0.0);
        EXPECT_LE(columns[i].threshold, 1.0);
        EXPECT_LT(columns[i].alias, columns.size());
    }
}

TEST(AliasTable, ReproducesEveryChance) {
    expectExact({1.0});
    expectExact({1.0, 1.0, 1.0});
    expectExact({1.0, 3.0});
    expectExact({1e-12, 1.0, 1e6});
    RandomNumbers random(71);
    std::vector<double> weights;
    for (int i = 0; i < 1000; ++i)
        weights.push_back(random.powerOfTen(-6.0, 2.0));
    expectExact(weights);
}

TEST(AliasTable, NeverChoosesWhatWeighsNothing) {
    const std::vector<AliasColumn> columns =
        buildAliasTable(std::vector<double>{0.0, 2.0, 0.0, 1.0});
    EXPECT_EQ(columns[0].threshold, 0.0);
    EXPECT_EQ(columns[2].threshold, 0.0);
    EXPECT_EQ(chancesOf(columns)[0], 0.0);
    EXPECT_EQ(chancesOf(columns)[2], 0.0);
}

TEST(AliasTable, OfNothingIsEmpty) { EXPECT_TRUE(buildAliasTable({}).empty()); }

} // namespace
} // namespace calotype::test
