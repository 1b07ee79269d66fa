// The input is a picture as the renderer writes them: EXR or PFM.

#include <filesystem>

#include "base/check.h"
#include "harness.h"
#include "image/exr.h"
#include "image/pfm.h"
#include "scratch_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace calotype::fuzz;
    static const ScratchFolder folder;
    const std::string path = folder.write("picture", textOf(data, size));
    // Each refuses the other's files by their first bytes.
    for (calotype::Image (*const read)(const std::filesystem::path&) :
         {calotype::readExr, calotype::readPfm})
        readOrRefuse([&] {
            const calotype::Image image = read(path);
            CALOTYPE_CHECK_LT(0u, image.pixels.size());
            CALOTYPE_CHECK_EQ(image.pixels.size(), size_t{image.width} * image.height);
        });
    return 0;
}
