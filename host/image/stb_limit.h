#pragma once

#include <cstddef>

namespace calotype {

/// stb_image may allocate so many bytes at once on this thread, and fails where it asks for more:
/// a small file can claim, or unpack to, any size.
extern thread_local size_t stbAllocationLimit;

} // namespace calotype
