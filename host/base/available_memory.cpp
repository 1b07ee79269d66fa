#include "base/available_memory.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>

#include <sys/resource.h>

namespace calotype {
namespace {

constexpr uint64_t kUnlimited = std::numeric_limits<uint64_t>::max();

/// Available memory and free swap, by Linux.
uint64_t systemMemory() {
    std::ifstream lines("/proc/meminfo");
    uint64_t kibibytes = 0;
    bool isKnown = false;
    for (std::string key, line; lines >> key; std::getline(lines, line)) {
        uint64_t value = 0;
        if ((key == "MemAvailable:" || key == "SwapFree:") && lines >> value) {
            kibibytes += value;
            isKnown = isKnown || key == "MemAvailable:";
        }
    }
    return isKnown ? kibibytes * 1024 : kUnlimited;
}

/// The limit of the control group, versions 2 and 1.
uint64_t groupLimit() {
    for (const char* path :
         {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        uint64_t limit = 0;
        if (std::ifstream(path) >> limit) // not "max"
            return limit;
    }
    return kUnlimited;
}

uint64_t processLimit() {
    rlimit limit{};
    const bool isLimited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return isLimited ? limit.rlim_cur : kUnlimited;
}

} // namespace

uint64_t availableMemory() { return std::min({systemMemory(), groupLimit(), processLimit()}); }

} // namespace calotype
