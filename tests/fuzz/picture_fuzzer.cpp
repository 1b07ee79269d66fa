// The input is a picture that `calotype compare` reads: EXR, PFM, HDR or PNG, by its content.

#include "base/check.h"
#include "harness.h"
#include "image/read_image.h"
#include "scratch_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace calotype::fuzz;
    // Larger ones spend the time on writing pixels.
    constexpr uint64_t kMostPixels = uint64_t{256} * 256;
    static const ScratchFolder folder;
    const std::string path = folder.write("picture", textOf(data, size));
    readOrRefuse([&] {
        const calotype::Image image = calotype::readImage(path, kMostPixels);
        CALOTYPE_CHECK_LT(0u, image.pixels.size());
        CALOTYPE_CHECK_EQ(image.pixels.size(), size_t{image.width} * image.height);
    });
    return 0;
}
