#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace calotype {

/// A result whose file cannot be written, such as on a full disk, is kept in another folder: the
/// first of those given, and then the one for temporary files, that takes it.
class SpareFile {
public:
    using Write = std::function<void(const std::filesystem::path&)>;

    /// `path` is the result's own file. It and `folders` may be relative.
    SpareFile(std::filesystem::path path, std::vector<std::filesystem::path> folders);

    /// Calls `write` with the result's own path. If that throws OutputError, calls it with a new
    /// name in the other folders, and throws OutputError again: with the message, where `what`,
    /// such as "the film", is kept, and the command that brings it to its place. Removes an earlier
    /// spare file if the result's own is written.
    void write(const char* what, const Write& write);

private:
    /// An empty path if no folder takes the result.
    std::filesystem::path writeElsewhere(const Write& write);

    std::filesystem::path path_;
    std::vector<std::filesystem::path> folders_;
    std::filesystem::path spare_; ///< written last; empty: none
};

/// The folders of these files, each once. Empty paths are ignored.
std::vector<std::filesystem::path> foldersOf(const std::vector<std::string>& paths);

} // namespace calotype
