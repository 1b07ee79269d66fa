#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "read/read_context.h"

namespace calotype {

/// The image that `name` means beside `directory` (see findFile), with the path that it was found
/// at. Each file is read, decoded and hashed once.
struct TextureFile {
    std::string path;
    std::shared_ptr<const TexelImage> image; ///< nullptr: missing
};

/// Throws SceneError at `where` for a missing file, unless the options say MissingTextures::Warn,
/// and at the file's path for one that is not an image.
TextureFile readTextureFile(const std::string& name, const std::filesystem::path& directory,
                            const std::string& where, ReadContext& context);

/// One texel of magenta, to show in place of a missing image.
std::shared_ptr<const TexelImage> magentaImage();

} // namespace calotype
