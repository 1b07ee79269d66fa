#include "cli/output_claims.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "film/film_file.h"
#include "image/image_format.h"

namespace calotype {
namespace {

/// A path that cannot be resolved cannot be written either, and is returned unchanged.
std::filesystem::path resolved(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(path, ignored);
}

bool isEmptyFile(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored) &&
           std::filesystem::file_size(path, ignored) == 0;
}

} // namespace

void OutputClaims::reserve(const std::string& path) {
    if (!path.empty())
        taken_.insert(resolved(path));
}

void OutputClaims::claim(const std::string& path) {
    if (!taken_.insert(resolved(path)).second)
        throw UsageError("'" + path + "' is read by this command, or is given twice");
    checkWritable(path);
}

void OutputClaims::claimPicture(const std::string& path) {
    if (!imageFormatOf(path))
        throw UsageError("the picture '" + path + "' has no known extension; use " +
                         std::string(kImageExtensions));
    claim(path);
}

void OutputClaims::claimFilm(const std::string& path) {
    if (imageFormatOf(path))
        throw UsageError("the film '" + path +
                         "' has the extension of a picture; name it otherwise, such as x.film");
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored) && !isFilm(path) && !isEmptyFile(path))
        throw UsageError("'" + path + "' exists and is no film; name another file");
    claim(path);
}

} // namespace calotype
