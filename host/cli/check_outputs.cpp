#include "cli/check_outputs.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/atomic_file.h"
#include "base/error.h"
#include "image/image_format.h"

namespace calotype {
namespace {

bool isExr(const std::string& path) { return imageFormatOf(path) == ImageFormat::Exr; }

} // namespace

void checkOutputs(const RenderOptions& options) {
    std::set<std::filesystem::path> taken = {std::filesystem::weakly_canonical(options.scene.path)};
    const auto claim = [&](const std::string& path) {
        std::error_code ignored; // a path that cannot be resolved cannot be written either
        if (!taken.insert(std::filesystem::weakly_canonical(path, ignored)).second)
            throw UsageError("'" + path + "' is the scene, or is given twice");
        checkWritable(path);
    };
    const auto claimPicture = [&](const std::string& path) {
        if (!imageFormatOf(path))
            throw UsageError("the picture '" + path + "' has no known extension; use " +
                             std::string(kImageExtensions));
        claim(path);
    };
    for (const std::string& path : options.outputs)
        claimPicture(path);
    if (!options.layers.empty() && std::ranges::none_of(options.outputs, isExr))
        throw UsageError("--aov writes layers of EXR files, and no output is one; add -o FILE.exr");
    if (!options.statsFile.empty())
        claim(options.statsFile);
    if (!options.previewFile.empty() && options.previewFile != options.outputs.front())
        claimPicture(options.previewFile);
}

} // namespace calotype
