#pragma once

#include <cstddef>
#include <cstdint>

#include <sys/mman.h>

namespace calotype {

constexpr size_t kHugePageBytes = size_t{2} << 20;

/// Advises the system to use huge pages for memory that has not been used yet, which makes random
/// reads faster. Nothing depends on the effect.
inline void adviseHugePages(void* begin, size_t bytes) {
    const auto address = reinterpret_cast<uintptr_t>(begin);
    const uintptr_t first = (address + kHugePageBytes - 1) / kHugePageBytes * kHugePageBytes;
    const uintptr_t end = (address + bytes) / kHugePageBytes * kHugePageBytes;
    if (first < end)
        madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

} // namespace calotype
