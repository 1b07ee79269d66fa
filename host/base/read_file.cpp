#include "base/read_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>

#include "base/error.h"
#include "base/names.h"

namespace calotype {
namespace {

constexpr size_t kChunk = 1 << 20;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// The rest of the file. `first` is the number of bytes to try to read at first. Calls `fail` with
/// the reason if it cannot be read.
std::string readAll(std::FILE* file, size_t first, const std::function<void(int)>& fail) {
    std::string bytes;
    size_t wanted = first;
    for (bool atEnd = false; !atEnd; wanted = kChunk) {
        const size_t start = bytes.size();
        bytes.resize(start + wanted);
        const size_t count = std::fread(bytes.data() + start, 1, wanted, file);
        bytes.resize(start + count);
        atEnd = count < wanted;
    }
    if (std::ferror(file))
        fail(errno);
    return bytes;
}

} // namespace

std::string readFile(const std::string& path, const std::string& where) {
    const auto fail = [&](int reason) {
        throw SceneError(where,
                         "cannot read the file " + inQuotes(path) + ": " + std::strerror(reason));
    };
    std::error_code unknownStatus;
    const auto status = std::filesystem::status(path, unknownStatus);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        // Pipes and devices may block, or never end.
        throw SceneError(where,
                         "cannot read the file " + inQuotes(path) + ": it is not a regular file");
    }
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file)
        fail(errno);
    std::error_code unknownSize;
    const auto size = std::filesystem::file_size(path, unknownSize);
    // One byte more than the size, to see the end.
    return readAll(file.get(), unknownSize ? kChunk : size + 1, fail);
}

std::string readStandardInput() {
    return readAll(stdin, kChunk, [](int reason) {
        throw SceneError("standard input", std::string("cannot be read: ") + std::strerror(reason));
    });
}

bool isReadableFile(const std::string& path) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    return std::filesystem::is_regular_file(status) &&
           std::unique_ptr<std::FILE, CloseFile>(std::fopen(path.c_str(), "rb")) != nullptr;
}

} // namespace calotype
