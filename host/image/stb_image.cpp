#include <cstdlib>

#include "image/stb_limit.h"

namespace calotype {

thread_local size_t stbAllocationLimit = 0;

} // namespace calotype

namespace {

/// Cleared memory, because a corrupt JPEG may refer to Huffman tables that it does not define.
void* allocateWithinLimit(size_t size) {
    return size <= calotype::stbAllocationLimit ? std::calloc(1, size) : nullptr;
}

void* reallocateWithinLimit(void* memory, size_t size) {
    return size <= calotype::stbAllocationLimit ? std::realloc(memory, size) : nullptr;
}

} // namespace

#define STBI_MALLOC(size) allocateWithinLimit(size)
#define STBI_REALLOC(memory, size) reallocateWithinLimit(memory, size)
#define STBI_FREE(memory) std::free(memory)
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
