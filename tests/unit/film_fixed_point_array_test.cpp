#include "film/fixed_point_array.h"

#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace calotype {
namespace {

constexpr size_t kSize = 2 * FixedPointArray::kChunkNumbers + 100;
constexpr FixedPoint kGreatest = ~(FixedPoint{1} << 127);

/// A number of either sign whose set bits are all in [lowestBit, lowestBit + bits).
FixedPoint randomNumber(std::mt19937_64& random, int lowestBit, int bits) {
    const auto word = static_cast<unsigned __int128>(random()) << 64 | random();
    const auto magnitude = static_cast<FixedPoint>(word >> (128 - bits)) << lowestBit;
    return random() % 2 == 0 ? magnitude : -magnitude;
}

void expectEqual(const FixedPointArray& array, const std::vector<FixedPoint>& expected) {
    ASSERT_EQ(array.size(), expected.size());
    std::vector<FixedPoint> all(expected.size());
    array.read(0, all);
    for (size_t i = 0; i < expected.size(); ++i) {
        ASSERT_TRUE(array[i] == expected[i]) << i;
        ASSERT_TRUE(all[i] == expected[i]) << i;
    }
}

TEST(FixedPointArrayTest, BeginsWithZerosThatTakeNoBytes) {
    const FixedPointArray array(kSize);
    expectEqual(array, std::vector<FixedPoint>(kSize));
    EXPECT_LT(array.memoryBytes(), kSize / 4);
}

/// Sums of terms of every magnitude and sign, in parts that begin and end anywhere.
TEST(FixedPointArrayTest, AddsExactly) {
    std::mt19937_64 random(1);
    FixedPointArray array(kSize);
    std::vector<FixedPoint> expected(kSize);
    for (int round = 0; round < 200; ++round) {
        const size_t first = random() % kSize;
        std::vector<FixedPoint> terms(1 + random() % (kSize - first));
        const int bits = 1 + static_cast<int>(random() % 60);
        const int lowestBit = static_cast<int>(random() % (118 - bits));
        for (FixedPoint& term : terms)
            term = randomNumber(random, lowestBit, bits);
        array.add(first, terms);
        for (size_t i = 0; i < terms.size(); ++i)
            expected[first + i] += terms[i];
        expectEqual(array, expected);
        if (HasFatalFailure())
            return;
    }
}

/// Each bit alone, each run of bits from the lowest and from the highest, and their negatives: the
/// ends of all ranges of bytes.
TEST(FixedPointArrayTest, HoldsEveryWidth) {
    std::vector<FixedPoint> numbers = {kGreatest, -kGreatest, -kGreatest - 1, 0, 1, -1};
    for (int bit = 0; bit < 127; ++bit) {
        const FixedPoint power = FixedPoint{1} << bit;
        numbers.insert(numbers.end(), {power, -power, power - 1, -power - 1});
    }
    for (const FixedPoint number : numbers) {
        FixedPointArray alone(3);
        alone.write(1, std::vector{number});
        expectEqual(alone, {0, number, 0});
        FixedPointArray other(3);
        other.write(1, std::vector{number ^ 1});
        EXPECT_FALSE(alone == other);
    }
    FixedPointArray together(numbers.size());
    together.write(0, numbers);
    expectEqual(together, numbers);
}

TEST(FixedPointArrayTest, AddsAnArray) {
    std::mt19937_64 random(2);
    std::vector<FixedPoint> a(kSize);
    std::vector<FixedPoint> b(kSize);
    for (size_t i = 0; i < kSize; ++i) {
        a[i] = randomNumber(random, 40, 30);
        b[i] = randomNumber(random, 10, 80);
    }
    FixedPointArray sum(kSize);
    FixedPointArray other(kSize);
    sum.write(0, a);
    other.write(0, b);
    sum.add(other);
    for (size_t i = 0; i < kSize; ++i)
        a[i] += b[i];
    expectEqual(sum, a);
    expectEqual(other, b);
}

TEST(FixedPointArrayTest, IsEqualWhateverItHeldBefore) {
    const std::vector<FixedPoint> numbers(kSize, FixedPoint{5} << 64);
    FixedPointArray fresh(kSize);
    fresh.write(0, numbers);
    FixedPointArray used(kSize);
    used.write(0, std::vector<FixedPoint>(kSize, kGreatest));
    used.write(0, numbers);
    EXPECT_TRUE(fresh == used);
    used.add(kSize - 1, std::vector{FixedPoint{1}});
    EXPECT_FALSE(fresh == used);
    EXPECT_FALSE(fresh == FixedPointArray(kSize - 1));
}

/// Radiance of 24 bits over 12 binary orders of magnitude has 36 bits, so 5 or 6 bytes.
TEST(FixedPointArrayTest, TakesTheBytesThatItsNumbersNeed) {
    std::mt19937_64 random(3);
    std::vector<FixedPoint> numbers(kSize);
    for (FixedPoint& number : numbers)
        number = randomNumber(random, 32 + static_cast<int>(random() % 12), 24);
    FixedPointArray array(kSize);
    array.write(0, numbers);
    EXPECT_LE(array.memoryBytes(), kSize * 6 + 3 * 64);
    EXPECT_LE(kSize * 5, array.memoryBytes());
}

} // namespace
} // namespace calotype
