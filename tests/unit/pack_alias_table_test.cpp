#include <gtest/gtest.h>

#include "pack/alias_table.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

constexpr uint64_t kNumbers = uint64_t{1} << 24; ///< that a random number may be, times 2^-24

/// How often each index is chosen by all random numbers, over how many they are.
std::vector<double> chancesOf(const std::vector<AliasColumn>& columns) {
    std::vector<uint64_t> counts(columns.size(), 0);
    uint64_t lastColumn = ~uint64_t{0};
    uint64_t place = 0;
    for (uint64_t number = 0; number < kNumbers; ++number) {
        const uint64_t column = number * columns.size() / kNumbers;
        place = column == lastColumn ? place + 1 : 0;
        lastColumn = column;
        ++counts[place < columns[column].ownNumbers ? column : columns[column].alias];
    }
    std::vector<double> chances;
    for (const uint64_t count : counts)
        chances.push_back(static_cast<double>(count) / kNumbers);
    return chances;
}

/// The chances are exactly those of the random numbers, and near the shares of the weights: each
/// has a number before the others are shared out, and loses less than one by rounding.
void expectChances(const std::vector<double>& weights) {
    const std::vector<AliasColumn> columns = buildAliasTable(weights);
    double sum = 0.0;
    for (const double weight : weights)
        sum += weight;
    const std::vector<double> chances = chancesOf(columns);
    ASSERT_EQ(columns.size(), weights.size());
    const auto count = static_cast<double>(columns.size());
    uint64_t next = 0;
    for (size_t i = 0; i < weights.size(); ++i) {
        EXPECT_EQ(columns[i].firstNumber, next);
        next += uint64_t{columns[i].ownNumbers} + columns[i].aliasNumbers;
        const double share = weights[i] / sum;
        EXPECT_EQ(columns[i].probability, chances[i]) << i;
        EXPECT_NEAR(columns[i].probability, share, (count * share + 2.0) * 0x1p-24) << i;
        EXPECT_LT(columns[i].alias, columns.size());
        EXPECT_EQ(columns[i].probability > 0.0, weights[i] > 0.0);
    }
    EXPECT_EQ(next, kNumbers);
}

TEST(AliasTableTest, ReproducesEveryChance) {
    expectChances({1.0});
    expectChances({1.0, 1.0, 1.0});
    expectChances({1.0, 3.0});
    expectChances({1e-12, 1.0, 1e6});
    RandomNumbers random(71);
    std::vector<double> weights;
    for (int i = 0; i < 1000; ++i)
        weights.push_back(random.powerOfTen(-6.0, 2.0));
    expectChances(weights);
}

TEST(AliasTableTest, NeverChoosesWhatWeighsNothing) {
    const std::vector<AliasColumn> columns =
        buildAliasTable(std::vector<double>{0.0, 2.0, 0.0, 1.0});
    EXPECT_EQ(columns[0].ownNumbers, 0u);
    EXPECT_EQ(columns[2].ownNumbers, 0u);
    EXPECT_EQ(chancesOf(columns)[0], 0.0);
    EXPECT_EQ(chancesOf(columns)[2], 0.0);
}

// A share of 1e-18 cannot be had of numbers of 24 bits: it gets one, and may get one that is left.
TEST(AliasTableTest, HasTheChanceOfWhatIsChosenMoreOftenThanItsShare) {
    const std::vector<AliasColumn> columns = buildAliasTable(std::vector<double>{1e-12, 1.0, 1e6});
    EXPECT_GE(columns[0].probability, 0x1p-24);
    EXPECT_LE(columns[0].probability, 0x1p-23);
    EXPECT_EQ(columns[0].probability, chancesOf(columns)[0]);
}

// Where more indices weigh something than there are numbers, those beyond are never chosen.
TEST(AliasTableTest, HasNoChanceWhereNoNumberFalls) {
    const std::vector<AliasColumn> columns =
        buildAliasTable(std::vector<double>(kNumbers + 1, 1.0));
    double sum = 0.0;
    size_t never = 0;
    for (const AliasColumn& column : columns) {
        sum += column.probability;
        never += column.probability == 0.0 ? 1 : 0;
    }
    EXPECT_EQ(sum, 1.0);
    EXPECT_EQ(never, 1u);
}

TEST(AliasTableTest, HasNoChanceWhereNothingWeighsAnything) {
    for (const AliasColumn& column : buildAliasTable(std::vector<double>(3, 0.0)))
        EXPECT_EQ(column.probability, 0.0);
}

TEST(AliasTableTest, OfNothingIsEmpty) { EXPECT_TRUE(buildAliasTable({}).empty()); }

} // namespace
} // namespace calotype::test
