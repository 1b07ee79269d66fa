#pragma once

#include <filesystem>
#include <string_view>

namespace calotype {

/// Replaces the file `path` by `bytes`, atomically: they are written to a temporary file in the
/// same folder, which is then renamed. A symbolic link stays, and its target is replaced; a device
/// or pipe is written directly. On failure, throws OutputError with the path and the system's
/// reason, an existing file is unchanged, and no temporary file is left.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// Throws the OutputError that writeFileAtomically would throw before its first byte: a missing or
/// unwritable folder, a folder or a write-protected file as target. Leaves no file, and does not
/// change an existing one.
void checkWritable(const std::filesystem::path& path);

} // namespace calotype
