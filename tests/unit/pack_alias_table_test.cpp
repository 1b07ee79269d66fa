#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pack/alias_table.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

constexpr uint64_t kNumbers = uint64_t{1} << 24; ///< that a random number may be, times 2^-24

/// How often each index is chosen by all pairs of random numbers, over the number of pairs.
std::vector<double> chancesOf(const std::vector<AliasColumn>& columns) {
    std::vector<double> chances(columns.size(), 0.0);
    for (uint64_t x = 0; x < kNumbers; ++x) {
        const AliasColumn& column = columns[x * columns.size() / kNumbers];
        const size_t own = static_cast<size_t>(&column - columns.data());
        chances[own] += column.threshold / double(kNumbers);
        chances[column.alias] += (1.0 - column.threshold) / double(kNumbers);
    }
    return chances;
}

/// The chances are exactly those of the random numbers, and near the shares of the weights: a
/// column's numbers are a whole number, and so is what a threshold lets through.
void expectChances(const std::vector<double>& weights) {
    const std::vector<AliasColumn> columns = buildAliasTable(weights);
    double sum = 0.0;
    for (const double weight : weights)
        sum += weight;
    const std::vector<double> chances = chancesOf(columns);
    ASSERT_EQ(columns.size(), weights.size());
    const auto count = static_cast<double>(columns.size());
    const double greatest = *std::ranges::max_element(weights) / sum;
    for (size_t i = 0; i < weights.size(); ++i) {
        const double share = weights[i] / sum;
        EXPECT_NEAR(columns[i].probability, chances[i], 1e-7 * chances[i] + 1e-15) << i;
        EXPECT_NEAR(columns[i].probability, share, (count * greatest + 1.0) * 0x1p-24) << i;
        EXPECT_EQ(columns[i].threshold * kNumbers, std::floor(columns[i].threshold * kNumbers));
        EXPECT_GE(columns[i].threshold, 0.0);
        EXPECT_LE(columns[i].threshold, 1.0);
        EXPECT_LT(columns[i].alias, columns.size());
        EXPECT_EQ(columns[i].probability > 0.0, weights[i] > 0.0);
    }
}

TEST(AliasTable, ReproducesEveryChance) {
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

TEST(AliasTable, NeverChoosesWhatWeighsNothing) {
    const std::vector<AliasColumn> columns =
        buildAliasTable(std::vector<double>{0.0, 2.0, 0.0, 1.0});
    EXPECT_EQ(columns[0].threshold, 0.0);
    EXPECT_EQ(columns[2].threshold, 0.0);
    EXPECT_EQ(chancesOf(columns)[0], 0.0);
    EXPECT_EQ(chancesOf(columns)[2], 0.0);
}

// A share of 1e-18 cannot be had of numbers of 24 bits: what happens is that the column's own light
// is chosen by the number 0, and its chance says so.
TEST(AliasTable, TellsTheChanceOfWhatIsChosenMoreOftenThanItsShare) {
    const std::vector<AliasColumn> columns = buildAliasTable(std::vector<double>{1e-12, 1.0, 1e6});
    EXPECT_EQ(columns[0].threshold, 0x1p-24);
    EXPECT_NEAR(columns[0].probability, 0x1p-24 / 3.0, 1e-7 * 0x1p-24);
}

// With more columns than numbers some columns are never chosen.
TEST(AliasTable, HasNoChanceWhereNoNumberFalls) {
    const std::vector<AliasColumn> columns =
        buildAliasTable(std::vector<double>(kNumbers + 1, 1.0));
    double sum = 0.0;
    size_t never = 0;
    for (const AliasColumn& column : columns) {
        sum += column.probability;
        never += column.probability == 0.0 ? 1 : 0;
    }
    EXPECT_NEAR(sum, 1.0, 1e-9);
    EXPECT_EQ(never, 1u);
}

TEST(AliasTable, OfNothingIsEmpty) { EXPECT_TRUE(buildAliasTable({}).empty()); }

} // namespace
} // namespace calotype::test
