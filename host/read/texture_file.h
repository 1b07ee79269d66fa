#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "read/read_context.h"

namespace calotype {

/// The image `name` relative to `directory` (see findFile), and the path at which it was found.
/// Each file is read, decoded and hashed once.
struct TextureFile {
    std::string path;
    std::shared_ptr<const TexelImage> image; ///< nullptr: missing
};

/// Throws SceneError at `where` if the file is missing, unless the options have
/// MissingTextures::Warn, and at the file's path if it is not an image.
TextureFile readTextureFile(const std::string& name, const std::filesystem::path& directory,
                            const std::string& where, ReadContext& context);

/// One texel of magenta, shown instead of a missing image.
std::shared_ptr<const TexelImage> magentaImage();

} // namespace calotype
