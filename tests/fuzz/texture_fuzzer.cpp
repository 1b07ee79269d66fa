// The input is an image file: PNG, JPEG, TGA, BMP or HDR.

#include "base/check.h"
#include "harness.h"
#include "image/read_texel_image.h"
#include "png_checksums.h"

/// libFuzzer's own.
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t largestSize);

/// Few changed PNGs would get past their checksums.
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t largestSize,
                                          unsigned) {
    size = LLVMFuzzerMutate(data, size, largestSize);
    calotype::fuzz::repairPngChecksums(data, size);
    return size;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace calotype::fuzz;
    constexpr uint32_t kLargestSide = 256; // so that time is not spent on filling memory
    readOrRefuse([&] {
        const calotype::TexelImage image =
            calotype::readTexelImage(textOf(data, size), kLargestSide, "image");
        CALOTYPE_CHECK_LT(0u, image.texelCount());
        CALOTYPE_CHECK_EQ(image.bytes.size() + image.floats.size(), 4 * image.texelCount());
    });
    return 0;
}
