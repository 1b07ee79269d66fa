#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace calotype {

/// Finds the regular file `name` relative to `directory`: exactly; with backslashes replaced by
/// slashes; ignoring case, also of folders (if several match, the exact one, else the first in
/// order); and, for an absolute path of another machine, by its longest end that exists in
/// `directory`.
std::optional<std::filesystem::path> findFile(const std::filesystem::path& directory,
                                              const std::string& name);

/// A suggestion for a message about a missing file: the most similar name in the deepest existing
/// folder of its path, as a path. Empty if none is similar.
std::string nearestFile(const std::filesystem::path& directory, const std::string& name);

} // namespace calotype
