#pragma once

#include <cstddef>

namespace calotype {

/// The most bytes that stb_image may allocate at once on this thread; it fails where it needs more.
/// Without a limit, a small file can claim, or unpack to, any size.
extern thread_local size_t stbAllocationLimit;

} // namespace calotype
