#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace calotype::test {

/// A line such as "VmRSS:  1024 kB" of /proc/self/status, in bytes.
inline int64_t memoryStatus(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (int64_t kibibytes = 0; word == key + ":" && status >> kibibytes)
            return kibibytes * 1024;
    ADD_FAILURE() << "/proc/self/status does not say " << key;
    return 0;
}

/// The most by which this process's memory exceeds, while `action` runs, what it was before, in
/// bytes: what is in use, by whatever allocator, not what is only reserved.
template <typename Action>
int64_t peakMemory(Action&& action) {
    std::ofstream("/proc/self/clear_refs") << "5"; // the high-water mark becomes what is in use
    const int64_t before = memoryStatus("VmRSS");
    action();
    return memoryStatus("VmHWM") - before;
}

} // namespace calotype::test
