#include "read/texture_file.h"

#include "base/error.h"
#include "base/find_file.h"
#include "base/names.h"
#include "base/read_file.h"
#include "image/read_texel_image.h"

namespace calotype {
namespace {

/// More than any size that readTexelImage accepts.
constexpr uintmax_t kLargestFile = uintmax_t{1} << 31;

void failOrWarn(const std::string& name, const std::filesystem::path& directory,
                const std::string& where, ReadContext& context) {
    const std::string missing = "there is no image file " + inQuotes(name);
    if (context.options.missingTextures == MissingTextures::Warn) {
        context.warn(where, missing + "; colours show magenta, and other maps are left out",
                     "missing image files");
        return;
    }
    const std::string nearest = nearestFile(directory, name);
    throw SceneError(
        where, missing + (nearest.empty() ? "" : "; did you mean " + inQuotes(nearest) + "?") +
                   " (--missing-textures warn goes on without it)");
}

} // namespace

TextureFile readTextureFile(const std::string& name, const std::filesystem::path& directory,
                            const std::string& where, ReadContext& context) {
    const auto found = findFile(directory, name);
    if (!found) {
        failOrWarn(name, directory, where, context);
        return {};
    }
    const std::string path = found->string();
    std::shared_ptr<const TexelImage>& cached = context.images[path];
    if (!cached) {
        std::error_code unknown;
        const uintmax_t size = std::filesystem::file_size(path, unknown);
        if (!unknown && size > kLargestFile)
            throw SceneError(path, "the image file is larger than 2 GiB");
        context.progress(path, 0.0);
        const std::string bytes = readFile(path, where);
        context.hash.add(bytes);
        cached =
            std::make_shared<TexelImage>(readTexelImage(bytes, ImageTexture::kLargestSide, path));
        context.progress(path, 1.0);
    }
    return {path, cached};
}

std::shared_ptr<const TexelImage> magentaImage() {
    auto image = std::make_shared<TexelImage>();
    image->width = 1;
    image->height = 1;
    image->bytes = {255, 0, 255, 255};
    image->isEncoded = true;
    return image;
}

} // namespace calotype
