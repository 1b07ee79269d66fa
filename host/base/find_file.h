#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace calotype {

/// The path of a file without links, "." and "..": one for all spellings. `path` itself if nothing
/// is there.
std::string truePath(const std::filesystem::path& path);

/// Finds files by names that were written on other machines. Lists each folder once, so that many
/// names take time in proportion to their number; later changes of the folders are not seen.
class FileFinder {
public:
    /// The regular file `name` relative to `directory`: exactly; with backslashes replaced by
    /// slashes; ignoring case, also of folders (if several match, the exact one, else the first in
    /// order); and, for an absolute path of another machine, by its longest end that exists in
    /// `directory`.
    std::optional<std::filesystem::path> find(const std::filesystem::path& directory,
                                              const std::string& name);

    /// A suggestion for a message about a missing file: the most similar name in the deepest
    /// existing folder of its path, as a path. Empty if none is similar.
    std::string nearest(const std::filesystem::path& directory, const std::string& name);

private:
    struct Listing {
        std::vector<std::string> names;                              ///< in order
        std::map<std::string, std::vector<std::string>> byLowercase; ///< names in order
    };

    const Listing& listingOf(const std::filesystem::path& folder);
    std::optional<std::filesystem::path>
    findInAnyCase(const std::filesystem::path& folder, std::filesystem::path::const_iterator next,
                  const std::filesystem::path::const_iterator& end);
    std::optional<std::filesystem::path> findInAnyCase(const std::filesystem::path& directory,
                                                       const std::string& name);

    std::map<std::string, Listing> listings_; ///< by the path of the folder
};

} // namespace calotype
