#include "base/atomic_file.h"

#include <csignal>
#include <functional>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

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

// The target of a link need not exist, and the link may be relative, or lead to another link.
TEST(AtomicFileTest, MakesTheTargetOfALink) {
    const ScratchFolder folder;
    fs::create_directory(folder / "elsewhere");
    fs::create_symlink("elsewhere/picture", folder / "link");
    fs::create_symlink("link", folder / "second");
    checkWritable(folder / "second");
    writeFileAtomically(folder / "second", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_symlink(folder / "second"));
    EXPECT_EQ(readBytes(folder / "elsewhere/picture"), "new");
    fs::create_symlink("circle", folder / "circle");
    expectRefused(folder / "circle", "Too many levels of symbolic links");
}

// One name for one file, however it is reached and whether or not it exists.
TEST(AtomicFileTest, NamesTheTargetOfAnOutput) {
    const ScratchFolder folder;
    const fs::path target = fs::canonical(folder.path()) / "new";
    fs::create_directory(folder / "sub");
    fs::create_symlink("../new", folder / "sub/link");
    fs::create_directory_symlink(".", folder / "here");
    for (const fs::path& path : {folder / "new", folder / "sub/../new", folder / "sub/link",
                                 folder / "here/new", fs::relative(folder / "new")})
        EXPECT_EQ(outputTarget(path), target) << path;
}

/// The twelve bits of the mode.
mode_t modeOf(const fs::path& path) {
    struct stat status {};
    EXPECT_EQ(stat(path.c_str(), &status), 0);
    return status.st_mode & 07777;
}

/// Sets the mask of new files' modes, and at the end the old one.
class Umask {
public:
    explicit Umask(mode_t mask) : old_(umask(mask)) {}
    Umask(const Umask&) = delete;
    Umask& operator=(const Umask&) = delete;
    ~Umask() { umask(old_); }

private:
    mode_t old_;
};

TEST(AtomicFileTest, KeepsTheModeOfAReplacedFile) {
    const ScratchFolder folder;
    for (const mode_t mask : {0022, 0077, 0000}) {
        const Umask umask(mask);
        const fs::path made = folder / ("made" + std::to_string(mask));
        writeFileAtomically(made, "new");
        EXPECT_EQ(modeOf(made), 0666 & ~mask);
        for (const mode_t mode : {0600, 0640, 0664, 0666, 0755}) {
            writeBytes(folder / "file", "old");
            chmod((folder / "file").c_str(), mode);
            checkWritable(folder / "file");
            writeFileAtomically(folder / "file", "new");
            EXPECT_EQ(modeOf(folder / "file"), mode);
            EXPECT_EQ(readBytes(folder / "file"), "new");
            fs::remove(folder / "file");
        }
    }
}

// Anybody may give a file to another of their groups; only root gives it to another owner.
TEST(AtomicFileTest, KeepsTheOwnerOfAReplacedFile) {
    if (geteuid() != 0)
        GTEST_SKIP() << "files of other owners need root";
    const ScratchFolder folder;
    writeBytes(folder / "file", "old");
    ASSERT_EQ(chown((folder / "file").c_str(), 12345, 23456), 0);
    chmod((folder / "file").c_str(), 0660);
    writeFileAtomically(folder / "file", "new");
    struct stat status {};
    ASSERT_EQ(stat((folder / "file").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, 12345u);
    EXPECT_EQ(status.st_gid, 23456u);
    EXPECT_EQ(status.st_mode & 07777, 0660u);
}

TEST(AtomicFileTest, KeepsExtendedAttributes) {
    const ScratchFolder folder;
    const std::string path = folder / "file";
    writeBytes(path, "old");
    if (setxattr(path.c_str(), "user.calotype", "mine", 4, 0) != 0)
        GTEST_SKIP() << "the file system of " << path << " has none";
    writeFileAtomically(path, "new");
    char value[16] = {};
    EXPECT_EQ(getxattr(path.c_str(), "user.calotype", value, sizeof value), 4);
    EXPECT_EQ(std::string(value), "mine");
}

// A name of as many bytes as the system allows leaves no room for a longer one beside it.
TEST(AtomicFileTest, WritesFilesOfLongNames) {
    const ScratchFolder folder;
    const fs::path path = folder / std::string(255, 'n');
    writeFileAtomically(path, "new");
    EXPECT_EQ(readBytes(path), "new");
    EXPECT_EQ(folder.entries(), 1u);
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
