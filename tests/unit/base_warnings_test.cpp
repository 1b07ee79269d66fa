// How warnings of one kind become one sentence.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/warnings.h"

namespace calotype {
namespace {

TEST(WarningsTest, OfDifferentKindsAreSentencesInTheirOrder) {
    Warnings warnings;
    warnings.add("b", "one");
    warnings.add("a", "two");
    warnings.add("b", "one");
    EXPECT_EQ(warnings.sentences(), (std::vector<std::string>{"b: one", "a: two"}));
}

TEST(WarningsTest, OfOneKindAreOneSentenceWithTheFirstPlaces) {
    Warnings warnings;
    const auto sentence = [&] { return warnings.sentences().at(0); };
    warnings.add("p1", "color 1 is odd", "odd colors");
    warnings.add("q", "another");
    warnings.add("p2", "color 2 is odd", "odd colors");
    EXPECT_EQ(sentence(), "p1: color 1 is odd (and 1 more of this kind, at p2)");
    warnings.add("p3", "color 3 is odd", "odd colors");
    EXPECT_EQ(sentence(), "p1: color 1 is odd (and 2 more of this kind, at p2, p3)");
    for (int i = 4; i <= 500; ++i)
        warnings.add("p" + std::to_string(i), "odd", "odd colors");
    EXPECT_EQ(sentence(), "p1: color 1 is odd (and 499 more of this kind, at p2, p3, ...)");
    EXPECT_EQ(warnings.sentences().size(), 2u);
    EXPECT_EQ(warnings.sentences()[1], "q: another");
}

TEST(WarningsTest, AppendedOnesFollowEachOnceWithTheirKinds) {
    Warnings first;
    first.add("p1", "color 1 is odd", "odd colors");
    first.add("q", "another");
    Warnings second;
    second.add("q", "another");
    second.add("r", "a third");
    second.add("p2", "color 2 is odd", "odd colors");
    first.append(second);
    EXPECT_EQ(first.sentences(),
              (std::vector<std::string>{"p1: color 1 is odd (and 1 more of this kind, at p2)",
                                        "q: another", "r: a third"}));
}

TEST(WarningsTest, EqualMessagesAreOfOneKind) {
    Warnings warnings;
    for (const char* place : {"a", "b", "b", "a"})
        warnings.add(place, "m");
    EXPECT_EQ(warnings.sentences(),
              std::vector<std::string>{"a: m (and 1 more of this kind, at b)"});
}

} // namespace
} // namespace calotype
