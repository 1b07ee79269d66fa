#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace calotype::test {

/// What AddressSanitizer adds: 256 MiB of freed memory that it keeps back, and an eighth of the
/// rest as its shadow (of the 2 GiB that the largest test uses).
#ifdef __SANITIZE_ADDRESS__
inline constexpr int64_t kSanitizerMemory = int64_t{640} << 20;
#else
inline constexpr int64_t kSanitizerMemory = 0;
#endif

/// How much memory this process has come to use, by whatever allocator, since the gauge was made;
/// in bytes, to within a MiB. What is reserved without being touched does not count.
class MemoryGauge {
public:
    MemoryGauge() {
        std::ofstream("/proc/self/clear_refs") << "5"; // the high-water mark falls to what is used
        before_ = status("VmRSS");
    }

    /// The most so far.
    int64_t peak() const { return status("VmHWM") - before_; }

private:
    /// A line such as "VmRSS:  1024 kB".
    static int64_t status(const std::string& key) {
        std::ifstream lines("/proc/self/status");
        for (std::string word; lines >> word;)
            if (int64_t kibibytes = 0; word == key + ":" && lines >> kibibytes)
                return kibibytes * 1024;
        ADD_FAILURE() << "/proc/self/status does not say " << key;
        return 0;
    }

    int64_t before_ = 0;
};

} // namespace calotype::test
