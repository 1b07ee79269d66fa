#include "cli/output_claims.h"

#include <algorithm>
#include <filesystem>
#include <regex>

#include "base/atomic_file.h"
#include "base/error.h"
#include "film/film_file.h"
#include "image/image_format.h"

namespace calotype {
namespace {

bool isEmptyFile(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored) &&
           std::filesystem::file_size(path, ignored) == 0;
}

[[noreturn]] void failReadAndWritten(const std::string& output, const std::string& input) {
    throw UsageError("the output '" + output + "' is read by this command" +
                     (input == output ? "" : ", as '" + input + "'") + "; write to another file");
}

/// "frame.%04d.png", "frame.####.png" and "frame.$F4.png".
bool numbersFrames(const std::string& path) {
    static const std::regex number(R"(%(0\d+)?d|##|\$F)");
    return std::regex_search(std::filesystem::path(path).filename().string(), number);
}

/// Names that are meant for something else than one file.
void requireFileName(const std::string& path) {
    std::error_code ignored;
    if (path == "-" || path.starts_with("-."))
        throw UsageError("nothing can be written to standard output; name a file in place of '" +
                         path + "'");
    if (numbersFrames(path))
        throw UsageError("'" + path +
                         "' has the number of a frame, and animations cannot be rendered yet; "
                         "name one file");
    if (std::filesystem::is_directory(path, ignored))
        throw UsageError("the output '" + path + "' is a folder; name a file in it");
}

} // namespace

bool isSameFile(const std::string& a, const std::string& b) {
    std::error_code missing; // a missing file is a different file
    return std::filesystem::equivalent(a, b, missing) && !missing;
}

void OutputClaims::reserve(const std::string& path) {
    if (path.empty())
        return;
    for (const Output& output : outputs_)
        if (isSameFile(output.path, path))
            failReadAndWritten(output.path, path);
    inputs_.push_back(path);
}

void OutputClaims::reserve(std::span<const std::string> paths) {
    for (const std::string& path : paths)
        reserve(path);
}

void OutputClaims::claim(const std::string& path) {
    requireFileName(path);
    for (const std::string& input : inputs_)
        if (isSameFile(path, input))
            failReadAndWritten(path, input);
    std::filesystem::path target = outputTarget(path);
    if (std::ranges::find(outputs_, target, &Output::target) != outputs_.end())
        throw UsageError("the output '" + path + "' is given twice");
    checkWritable(path);
    OutputLock lock(target, path);
    outputs_.push_back({path, std::move(target), std::move(lock)});
}

void OutputClaims::claimPicture(const std::string& path) {
    requireFileName(path);
    if (!imageFormatOf(path))
        throw UsageError("the picture '" + path + "' has no known extension; use " +
                         std::string(kImageExtensions));
    claim(path);
}

void OutputClaims::claimFilm(const std::string& path) {
    requireFileName(path);
    if (imageFormatOf(path))
        throw UsageError("the film '" + path +
                         "' has the extension of a picture; name it otherwise, such as x.film");
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored) && !isFilm(path) && !isEmptyFile(path))
        throw UsageError("'" + path + "' exists and is no film; name another file");
    claim(path);
}

} // namespace calotype
