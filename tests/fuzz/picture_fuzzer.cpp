// The input is a picture that `calotype compare` reads: EXR, PFM, HDR or PNG, told by its content.

#include "base/check.h"
#include "harness.h"
#include "image/read_image.h"
#include "scratch_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace calotype::fuzz;
    static const ScratchFolder folder;
    const std::string path = folder.write("picture", textOf(data, size));
    readOrRefuse([&] {
        const calotype::Image image = calotype::readImage(path);
        CALOTYPE_CHECK_LT(0u, image.pixels.size());
        CALOTYPE_CHECK_EQ(image.pixels.size(), size_t{image.width} * image.height);
    });
    return 0;
}
