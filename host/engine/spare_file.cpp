#include "engine/spare_file.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "base/error.h"
#include "base/names.h"

namespace calotype {
namespace {

namespace fs = std::filesystem;

/// "FOLDER/frame.1234.exr" for "frame.exr", by the number of the process; no file has the name.
fs::path newName(const fs::path& folder, const fs::path& path) {
    constexpr size_t kLongestStem = 200; // of 255 bytes, with what is added
    const std::string start =
        path.stem().string().substr(0, kLongestStem) + "." + std::to_string(::getpid());
    std::error_code ignored;
    fs::path name = folder / (start + path.extension().string());
    for (int i = 1; fs::exists(fs::symlink_status(name, ignored)); ++i)
        name = folder / (start + "-" + std::to_string(i) + path.extension().string());
    return name;
}

bool triesToWrite(const SpareFile::Write& write, const fs::path& path) {
    try {
        write(path);
        return true;
    } catch (const OutputError&) {
        return false;
    }
}

} // namespace

SpareFile::SpareFile(fs::path path, std::vector<fs::path> folders)
    : path_(std::move(path)), folders_(std::move(folders)) {
    std::erase_if(folders_, [&](const fs::path& folder) {
        std::error_code missing;
        const fs::path own = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
        return fs::equivalent(folder, own, missing);
    });
    std::error_code none;
    if (fs::path temporary = fs::temp_directory_path(none); !none)
        folders_.push_back(std::move(temporary));
    folders_.insert(folders_.end(), {"/tmp", "/var/tmp", "."});
}

void SpareFile::write(const char* what, const Write& write) {
    try {
        write(path_);
    } catch (const OutputError& error) {
        spare_ = writeElsewhere(write);
        if (spare_.empty())
            throw;
        throw OutputError(std::string(error.what()) + "; " + what + " is kept in '" +
                          spare_.string() + "'; when there is room: mv " +
                          shellWord(spare_.string()) + " " + shellWord(path_.string()));
    }
    std::error_code ignored;
    if (!spare_.empty())
        fs::remove(std::exchange(spare_, {}), ignored);
}

fs::path SpareFile::writeElsewhere(const Write& write) {
    if (!spare_.empty() && triesToWrite(write, spare_))
        return spare_;
    for (const fs::path& folder : folders_)
        if (const fs::path name = newName(folder, path_); triesToWrite(write, name))
            return name;
    return {};
}

std::vector<fs::path> foldersOf(const std::vector<std::string>& paths) {
    std::vector<fs::path> folders;
    for (const fs::path path : paths) {
        fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
        if (!path.empty() && std::ranges::find(folders, folder) == folders.end())
            folders.push_back(std::move(folder));
    }
    return folders;
}

} // namespace calotype
