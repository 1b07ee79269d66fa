#include "base/atomic_file.h"

#include <csignal>
#include <functional>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/error.h"
#include "support/scratch_folder.h"

namespace calotype {
namespace {

using test::readBytes;
using test::ScratchFolder;
using test::writeBytes;
namespace fs = std::filesystem;

std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const OutputError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

testing::AssertionResult contains(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "\"" << text << "\" lacks \"" << part << "\"";
}

/// The two must agree on what they refuse.
void expectRefused(const fs::path& path, const std::string& reason) {
    for (const std::string& message : {messageOf([&] { writeFileAtomically(path, "bytes"); }),
                                       messageOf([&] { checkWritable(path); })}) {
        EXPECT_TRUE(contains(message, path.string()));
        EXPECT_TRUE(contains(message, reason));
    }
}

/// Lets the process write no file longer than `bytes`: to write(), it is as if the disk were full.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : oldHandler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, oldHandler_);
    }

private:
    void (*oldHandler_)(int);
    rlimit old_{};
};

TEST(AtomicFileTest, WritesAllBytesAndNothingElse) {
    const ScratchFolder folder;
    const std::string bytes("a\0b\xff\n", 5);
    writeFileAtomically(folder / "new.bin", bytes);
    EXPECT_EQ(readBytes(folder / "new.bin"), bytes);
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFileTest, ReplacesAFileByRenaming) {
    const ScratchFolder folder;
    writeBytes(folder / "picture", "old");
    std::ifstream reader(folder / "picture");
    writeFileAtomically(folder / "picture", "brand new");
    std::string seen;
    reader >> seen;
    EXPECT_EQ(seen, "old") << "whoever had the old file open must keep all of it";
    EXPECT_EQ(readBytes(folder / "picture"), "brand new");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFileTest, FailureKeepsTheOldFileAndLeavesNoDebris) {
    const ScratchFolder folder;
    writeBytes(folder / "picture", "old");
    {
        const FileSizeLimit limit(1000);
        const std::string tooMuch(1001, 'x');
        const std::string message =
            messageOf([&] { writeFileAtomically(folder / "picture", tooMuch); });
        EXPECT_TRUE(contains(message, (folder / "picture").string()));
        EXPECT_TRUE(contains(message, "File too large"));
    }
    EXPECT_EQ(readBytes(folder / "picture"), "old");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFileTest, FollowsALinkAndKeepsIt) {
    const ScratchFolder folder;
    fs::create_directory(folder / "elsewhere");
    writeBytes(folder / "elsewhere/picture", "old");
    fs::create_symlink("elsewhere/picture", folder / "link");
    writeFileAtomically(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(readBytes(folder / "elsewhere/picture"), "new");
}

TEST(AtomicFileTest, WritesToADeviceInPlace) {
    writeFileAtomically("/dev/null", "bytes");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    const std::string message = messageOf([] { writeFileAtomically("/dev/full", "bytes"); });
    EXPECT_TRUE(contains(message, "/dev/full"));
    EXPECT_TRUE(contains(message, "No space left on device"));
}

TEST(AtomicFileTest, RefusesPathsThatCannotBeWritten) {
    const ScratchFolder folder;
    writeBytes(folder / "file", "");
    expectRefused("", "No such file or directory");
    expectRefused(folder / "missing/picture.png", "No such file or directory");
    expectRefused(folder / "missing/", "No such file or directory");
    expectRefused(folder.path(), "Is a directory");
    expectRefused(folder / "file/picture.png", "Not a directory");
    expectRefused(folder / std::string(300, 'n'), "File name too long");
    expectRefused("/proc/picture.png", "No such file or directory");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFileTest, CheckLeavesNothingBehindAndTouchesNothing) {
    const ScratchFolder folder;
    checkWritable(folder / "new.png");
    EXPECT_EQ(folder.entries(), 0u);

    writeBytes(folder / "old.png", "old");
    const auto longAgo = fs::file_time_type::clock::now() - std::chrono::hours(1);
    fs::last_write_time(folder / "old.png", longAgo);
    checkWritable(folder / "old.png");
    EXPECT_EQ(readBytes(folder / "old.png"), "old");
    EXPECT_EQ(fs::last_write_time(folder / "old.png"), longAgo);
    EXPECT_EQ(folder.entries(), 1u);
}

} // namespace
} // namespace calotype
