#include "base/output_lock.h"

#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "support/scratch_folder.h"

namespace calotype {
namespace {

using test::ScratchFolder;
using test::writeBytes;

std::string messageOfLock(const std::filesystem::path& target) {
    try {
        const OutputLock lock(target, target);
    } catch (const OutputBusyError& error) {
        return error.what();
    }
    return "";
}

TEST(OutputLockTest, IsOfOneAtATime) {
    const ScratchFolder folder;
    const std::filesystem::path target = folder / "a.film";
    {
        const OutputLock lock(target, target);
        const std::string message = messageOfLock(target);
        EXPECT_NE(message.find(target.string()), std::string::npos) << message;
        EXPECT_NE(message.find("process " + std::to_string(getpid()) + " on "), std::string::npos)
            << message;
        EXPECT_EQ(messageOfLock(folder / "b.film"), "");
    }
    EXPECT_EQ(folder.entries(), 0u);
    EXPECT_EQ(messageOfLock(target), "");
}

TEST(OutputLockTest, GoesWithItsOwner) {
    const ScratchFolder folder;
    OutputLock first(folder / "a", "a");
    OutputLock second = std::move(first);
    EXPECT_NE(messageOfLock(folder / "a"), "");
    second = OutputLock(folder / "b", "b");
    EXPECT_EQ(messageOfLock(folder / "a"), "");
    EXPECT_NE(messageOfLock(folder / "b"), "");
}

// It ends with the process, however that ends; then what that left is removed, and nothing else.
TEST(OutputLockTest, EndsWithAKilledProcess) {
    const ScratchFolder folder;
    const std::filesystem::path target = folder / "a.film";
    if (const pid_t child = fork(); child == 0) {
        const OutputLock lock(target, target);
        _exit(0); // without its destructor
    } else {
        waitpid(child, nullptr, 0);
    }
    EXPECT_EQ(folder.entries(), 1u) << "the file of the lock";
    writeBytes(fileBeside(target, "123-0.tmp"), "half a film");
    writeBytes(fileBeside(folder / "b.film", "123-0.tmp"), "another's");
    writeBytes(folder / "a.film.tmp", "the user's");
    EXPECT_EQ(messageOfLock(target), "");
    EXPECT_FALSE(std::filesystem::exists(fileBeside(target, "123-0.tmp")));
    EXPECT_EQ(folder.entries(), 2u);
}

// Where another process may be writing without a lock, nothing is removed.
TEST(OutputLockTest, LeavesTemporaryFilesWhereNobodyWasKilled) {
    const ScratchFolder folder;
    writeBytes(fileBeside(folder / "a.film", "123-0.tmp"), "half a film");
    EXPECT_EQ(messageOfLock(folder / "a.film"), "");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(OutputLockTest, LocksNoDevices) {
    const OutputLock lock("/dev/null", "/dev/null");
    EXPECT_EQ(messageOfLock("/dev/null"), "");
    EXPECT_FALSE(std::filesystem::exists(fileBeside("/dev/null", "lock")));
}

} // namespace
} // namespace calotype
