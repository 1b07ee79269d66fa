#include "base/read_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "base/error.h"
#include "base/names.h"

namespace calotype {
namespace {

constexpr size_t kChunk = 1 << 20;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

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
    std::string bytes;
    std::error_code unknownSize;
    const auto size = std::filesystem::file_size(path, unknownSize);
    size_t wanted = unknownSize ? kChunk : size + 1; // one more, to see the end
    size_t count = 0;
    for (bool atEnd = false; !atEnd; wanted = kChunk) {
        const size_t start = bytes.size();
        bytes.resize(start + wanted);
        count = std::fread(bytes.data() + start, 1, wanted, file.get());
        bytes.resize(start + count);
        atEnd = count < wanted;
    }
    if (std::ferror(file.get()))
        fail(errno);
    return bytes;
}

bool isReadableFile(const std::string& path) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    return std::filesystem::is_regular_file(status) &&
           std::unique_ptr<std::FILE, CloseFile>(std::fopen(path.c_str(), "rb")) != nullptr;
}

} // namespace calotype
