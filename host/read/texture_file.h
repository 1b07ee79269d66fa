#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "read/read_context.h"

namespace calotype {

/// The image `name` relative to `directory` (see FileFinder), and its true path. Each file is read,
/// decoded and hashed once, in whatever ways its path is written.
struct TextureFile {
    std::string path;
    std::shared_ptr<const TexelImage> image; ///< nullptr: missing, or cannot be read
};

/// Throws SceneError at `where` if the file is missing, and at the file's path if it cannot be read
/// as an image; with MissingTextures::Warn in the options, adds a warning instead.
TextureFile readTextureFile(const std::string& name, const std::filesystem::path& directory,
                            const std::string& where, ReadContext& context);

/// Counts the image, if it is there, for the budget of the context. Readers do this for all images
/// of a file, and call startTextures before they read the first.
void countTexture(const std::string& name, const std::filesystem::path& directory, bool isUploaded,
                  ReadContext& context);

/// Throws GpuError or Error if the images that were counted exceed the memory (see
/// TextureBudget::require). Starts to read and decode them on other threads.
void startTextures(ReadContext& context);

/// One texel of magenta, shown instead of an image that is missing or cannot be read.
std::shared_ptr<const TexelImage> magentaImage();

} // namespace calotype
