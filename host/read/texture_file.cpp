#include "read/texture_file.h"

#include <string>

#include "base/error.h"
#include "base/find_file.h"
#include "base/names.h"
#include "image/read_texel_image.h"

namespace calotype {
namespace {

/// More than any size that readTexelImage accepts.
constexpr uintmax_t kLargestFile = uintmax_t{1} << 31;
static_assert(kMostBytesAhead <= kLargestFile, "larger files are refused before they are read");

constexpr const char* kHint = " (--missing-textures warn goes on without it)";

/// Why nothing was found: what is at that very place cannot be opened as a file, or nothing is.
std::string whyMissing(const std::string& name, const std::filesystem::path& directory) {
    std::error_code unknown;
    const std::filesystem::path path = directory / name;
    if (name.empty() || !std::filesystem::exists(path, unknown))
        return "there is no image file " + inQuotes(name);
    if (std::filesystem::is_directory(path, unknown))
        return "the image file " + inQuotes(name) + " is a folder";
    return "the image file " + inQuotes(name) + " cannot be opened; check that it may be read";
}

void warnOf(const std::string& problem, const std::string& where, ReadContext& context) {
    context.warn(where, problem + "; a colour shows magenta, another map is left out",
                 "image files that cannot be read");
}

TextureFile failOrWarn(const std::string& name, const std::filesystem::path& directory,
                       const std::string& where, ReadContext& context) {
    const std::string problem = whyMissing(name, directory);
    if (context.options.missingTextures == MissingTextures::Warn) {
        warnOf(problem, where, context);
        return {};
    }
    const std::string nearest = context.finder.nearest(directory, name);
    throw SceneError(
        where,
        problem + (nearest.empty() ? "" : "; did you mean " + inQuotes(nearest) + "?") + kHint);
}

std::shared_ptr<const TexelImage> readImageFile(const std::string& path, const std::string& where,
                                                ReadContext& context) {
    std::error_code unknown;
    const uintmax_t size = std::filesystem::file_size(path, unknown);
    if (!unknown && size > kLargestFile)
        throw SceneError(path, "the image file is larger than 2 GiB");
    const auto onProgress = [&](double done) { context.progress(path, done); };
    onProgress(0.0);
    auto image = context.takeAhead(path, context.imagesAhead, onProgress);
    if (!image)
        image = std::make_shared<const TexelImage>(
            readTexelImage(context.read(path, where), ImageTexture::kLargestSide, path));
    onProgress(1.0);
    return image;
}

/// The message of an error without its place.
std::string problemOf(const SceneError& error) {
    return std::string(error.what()).substr(error.where().size() + 2); // after ": "
}

} // namespace

TextureFile readTextureFile(const std::string& name, const std::filesystem::path& directory,
                            const std::string& where, ReadContext& context) {
    const auto found = context.finder.find(directory, name);
    if (!found)
        return failOrWarn(name, directory, where, context);
    const std::string key = truePath(*found);
    const auto cached = context.images.find(key);
    if (cached != context.images.end())
        return {key, cached->second};
    try {
        return {key, context.images[key] = readImageFile(found->string(), where, context)};
    } catch (const SceneError& error) {
        if (context.options.missingTextures == MissingTextures::Fail)
            throw SceneError(error.where(), problemOf(error) + kHint);
        warnOf("the image file " + inQuotes(name) + " cannot be read: " + problemOf(error), where,
               context);
        context.images[key] = nullptr; // so that it is read once
        return {};
    }
}

void countTexture(const std::string& name, const std::filesystem::path& directory, bool isUploaded,
                  ReadContext& context) {
    if (const auto path = context.finder.find(directory, name))
        context.textureBudget.add(truePath(*path), isUploaded);
}

void startTextures(ReadContext& context) {
    context.textureBudget.require(context.options);
    for (const std::string& path : context.textureBudget.takeNew())
        context.startAhead(path, context.imagesAhead,
                           [path](std::string_view bytes, const OnProgress&) {
                               return readTexelImage(bytes, ImageTexture::kLargestSide, path);
                           });
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
