#include "read/files_ahead.h"

#include <algorithm>

#include "base/available_memory.h"

namespace calotype {

uint64_t bytesAhead() {
    constexpr uint64_t kShareOfMemory = 8; // the rest is for what is made of the files
    return std::min(kMostBytesAhead, availableMemory() / kShareOfMemory);
}

} // namespace calotype
