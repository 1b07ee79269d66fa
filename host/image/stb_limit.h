#pragma once

#include <cstddef>

namespace calotype {

/// The most bytes that stb_image may allocate at once on this thread; it fails if it needs more.
/// Without a limit, a small file can claim any size, or decompress to it.
extern thread_local size_t stbAllocationLimit;

} // namespace calotype
