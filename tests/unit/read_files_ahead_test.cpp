// Files that are read on other threads before their turn, and how many bytes they hold.
#include "read/files_ahead.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "support/program.h"

namespace calotype::test {
namespace {

class FilesAheadTest : public testing::Test {
protected:
    using Ahead = FilesAhead<std::string>;

    void start(const std::string& name, size_t bytes) {
        folder_.write(name, std::string(bytes, 'x'));
        ahead_.start(folder_ / name, tasks_, [name](const OnProgress&) {
            return Ahead::File{name, std::make_shared<const std::string>("of " + name)};
        });
    }

    /// Whether it was read ahead.
    bool take(const std::string& name) {
        const auto file = ahead_.take(folder_ / name, tasks_);
        if (file) {
            EXPECT_EQ(file->bytes, name);
            EXPECT_EQ(*file->contents, "of " + name);
        }
        return file.has_value();
    }

    TestFolder folder_;
    Ahead ahead_{10};
    TaskPool tasks_{1};
};

TEST_F(FilesAheadTest, EachIsTakenOnce) {
    start("a", 4);
    start("a", 4);
    start("b", 6);
    EXPECT_TRUE(take("b"));
    EXPECT_TRUE(take("a"));
    EXPECT_FALSE(take("a"));
    EXPECT_FALSE(take("c"));
}

// A file that still waits when its turn comes is read in its turn.
TEST_F(FilesAheadTest, FilesWaitUntilThereIsRoomForTheirBytes) {
    for (const char* name : {"a", "b", "c", "d", "e"})
        start(name, 4);
    EXPECT_FALSE(take("c")) << "8 of 10 bytes are held";
    EXPECT_TRUE(take("a")) << "now d is started, since c has been read";
    EXPECT_FALSE(take("e"));
    EXPECT_TRUE(take("d"));
    EXPECT_TRUE(take("b"));
}

TEST_F(FilesAheadTest, TheOrderIsKeptWhereALargeFileWaits) {
    start("a", 6);
    start("large", 7);
    start("b", 4);
    EXPECT_FALSE(take("b"));
    EXPECT_TRUE(take("a"));
    EXPECT_TRUE(take("large"));
}

TEST_F(FilesAheadTest, AFileAboveTheLimitIsNotStartedAndHoldsUpNoOther) {
    start("large", 11);
    start("a", 10);
    EXPECT_FALSE(take("large"));
    EXPECT_TRUE(take("a"));
}

TEST_F(FilesAheadTest, AFileThatCannotBeReadFreesItsRoom) {
    folder_.write("bad", std::string(10, 'x'));
    ahead_.start(folder_ / "bad", tasks_,
                 [](const OnProgress&) -> Ahead::File { throw SceneError("bad", "is no file"); });
    start("a", 10);
    EXPECT_FALSE(take("bad"));
    EXPECT_TRUE(take("a"));
}

TEST(BytesAheadTest, AreAtMostAGibibyte) {
    EXPECT_GT(bytesAhead(), 0u);
    EXPECT_LE(bytesAhead(), kMostBytesAhead);
}

} // namespace
} // namespace calotype::test
