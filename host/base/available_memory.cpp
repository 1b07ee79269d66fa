#include "base/available_memory.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

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

/// The number in a file; none if it holds something else, such as "max".
std::optional<uint64_t> numberIn(const std::string& path) {
    uint64_t number = 0;
    if (std::ifstream(path) >> number)
        return number;
    return std::nullopt;
}

/// The number after a word in a file of lines "word number"; 0 if it is not there.
uint64_t numberAfter(const std::string& word, const std::string& path) {
    std::ifstream lines(path);
    uint64_t number = 0;
    for (std::string key; lines >> key >> number;)
        if (key == word)
            return number;
    return 0;
}

uint64_t leftOf(uint64_t limit, uint64_t used) { return limit - std::min(used, limit); }

/// What the limit of the control group leaves, in versions 2 and 1. Pages of files that were not
/// used for long count as used, but the system takes them back.
uint64_t groupMemory() {
    struct Files {
        std::string limit, used, details, reclaimable;
    };
    const std::string second = "/sys/fs/cgroup/";
    const std::string first = second + "memory/";
    for (const Files& files :
         {Files{second + "memory.max", second + "memory.current", second + "memory.stat",
                "inactive_file"},
          Files{first + "memory.limit_in_bytes", first + "memory.usage_in_bytes",
                first + "memory.stat", "total_inactive_file"}})
        if (const auto limit = numberIn(files.limit))
            return leftOf(*limit, leftOf(numberIn(files.used).value_or(0),
                                         numberAfter(files.reclaimable, files.details)));
    return kUnlimited;
}

/// What the limit of the process's address space leaves.
uint64_t processMemory() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return kUnlimited;
    const auto pageSize = static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
    return leftOf(limit.rlim_cur, numberIn("/proc/self/statm").value_or(0) * pageSize);
}

} // namespace

uint64_t availableMemory() { return std::min({systemMemory(), groupMemory(), processMemory()}); }

} // namespace calotype
