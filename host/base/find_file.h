#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace calotype {

/// The regular file that `name` means beside `directory`, however it was written: as it is; with
/// backslashes for slashes; in another case, folders included (where several differ in case only,
/// the exact one, else the first in order); and, where it is an absolute path of another machine,
/// by its longest end that is found in `directory`.
std::optional<std::filesystem::path> findFile(const std::filesystem::path& directory,
                                              const std::string& name);

/// What a message about a missing file may suggest: the nearest name in the deepest folder on the
/// way to it, as a path that could be written instead. Empty where nothing is near.
std::string nearestFile(const std::filesystem::path& directory, const std::string& name);

} // namespace calotype
