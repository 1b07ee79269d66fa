#include "base/available_memory.h"

#include <cstdint>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

namespace calotype {
namespace {

constexpr uint64_t kRoom = 64 << 20;

/// Exits with 0 if that is what a limit on the address space leaves besides what is in use.
[[noreturn]] void limitMemoryAndLook() {
    uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const uint64_t limit = pages * static_cast<uint64_t>(sysconf(_SC_PAGESIZE)) + kRoom;
    const rlimit both{limit, limit};
    setrlimit(RLIMIT_AS, &both);
    const uint64_t available = availableMemory();
    std::exit(available > kRoom / 2 && available <= kRoom ? 0 : 1);
}

TEST(AvailableMemoryTest, IsWhatALimitLeaves) {
    EXPECT_GT(availableMemory(), uint64_t{1} << 20);
    EXPECT_EXIT(limitMemoryAndLook(), testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace calotype
