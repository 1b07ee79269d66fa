// The hash of texts, which scenes and films are recognised by.

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "base/content_hash.h"

namespace calotype::test {
namespace {

uint64_t hashOf(std::span<const std::string_view> pieces) {
    ContentHash hash;
    hash.add(pieces);
    return hash.value();
}

TEST(ContentHashTest, OfPiecesIsThatOfTheirText) {
    const std::string text = "The quick brown fox jumps over it";
    ContentHash whole;
    whole.add(text);
    const std::string_view all = text;
    for (size_t a = 0; a <= text.size(); ++a)
        for (size_t b = a; b <= text.size(); ++b) {
            const std::string_view pieces[] = {all.substr(0, a), all.substr(a, b - a),
                                               all.substr(b)};
            ASSERT_EQ(hashOf(pieces), whole.value()) << a << " " << b;
        }
}

// Films and scenes of earlier programs hold these values.
TEST(ContentHashTest, IsThatOfEarlierPrograms) {
    ContentHash hash;
    hash.add("abc");
    // splitmix64's finaliser of the length 3, then of the word 0x636261 mixed into it.
    const auto mix = [](uint64_t state, uint64_t word) {
        uint64_t z = (state ^ word) + 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    };
    EXPECT_EQ(hash.value(), mix(mix(0, 3), 0x636261));
    hash.add("");
    EXPECT_EQ(hash.value(), mix(mix(mix(0, 3), 0x636261), 0));
}

} // namespace
} // namespace calotype::test
