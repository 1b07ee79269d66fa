#include "base/terminal_text.h"

#include <gtest/gtest.h>

namespace calotype {
namespace {

TEST(TerminalTextTest, CutsPlainTextAtTheWidth) {
    EXPECT_EQ(fittedText("", 5), "");
    EXPECT_EQ(fittedText("abcde", 5), "abcde");
    EXPECT_EQ(fittedText("abcdef", 5), "abcde");
    EXPECT_EQ(fittedText("abc", 0), "");
}

TEST(TerminalTextTest, CountsWideCharactersAsTwo) {
    EXPECT_EQ(fittedText("\u00e4\u00f6\u00fc.obj", 3), "\u00e4\u00f6\u00fc");
    EXPECT_EQ(fittedText("\u6905\u5b50.obj", 8), "\u6905\u5b50.obj");
    EXPECT_EQ(fittedText("\u6905\u5b50.obj", 4), "\u6905\u5b50");
    EXPECT_EQ(fittedText("\u6905\u5b50.obj", 3), "\u6905") << "no half characters";
    EXPECT_EQ(fittedText("\U0001F600!", 3), "\U0001F600!");
    EXPECT_EQ(fittedText("\U0001F600!", 1), "");
}

TEST(TerminalTextTest, HasNoControlCharacters) {
    EXPECT_EQ(fittedText("a\nb\033[2Jc\x7f", 20), "a?b?[2Jc?");
    EXPECT_EQ(fittedText("a\u009b2J", 20), "a?2J") << "the same as an escape and a bracket";
    EXPECT_EQ(fittedText("a\u202eb", 20), "a?b") << "would turn the line around";
}

TEST(TerminalTextTest, ShowsBrokenUtf8) {
    EXPECT_EQ(fittedText("a\xffz", 20), "a?z");
    EXPECT_EQ(fittedText("a\xc3", 20), "a?");
    EXPECT_EQ(fittedText("a\xe6\xa4z", 20), "a??z");
    EXPECT_EQ(fittedText("\xc0\xaf", 20), "??") << "an overlong form";
}

TEST(TerminalTextTest, LeavesOutPartsOfTheHighestRank) {
    const std::vector<LinePart> parts = {
        {"[##..]", 2}, {" 50 %", 0}, {"", 9}, {"8/16 spp", 1}, {"1 M rays/s", 3}};
    EXPECT_EQ(fittedLine(parts, 35), "[##..]   50 %  8/16 spp  1 M rays/s");
    EXPECT_EQ(fittedLine(parts, 34), "[##..]   50 %  8/16 spp");
    EXPECT_EQ(fittedLine(parts, 22), " 50 %  8/16 spp");
    EXPECT_EQ(fittedLine(parts, 14), " 50 %");
    EXPECT_EQ(fittedLine(parts, 3), " 50");
    EXPECT_EQ(fittedLine({}, 3), "");
}

} // namespace
} // namespace calotype
