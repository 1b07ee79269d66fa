#pragma once

#include <filesystem>
#include <string_view>

namespace calotype {

/// Replaces the file `path` by `bytes`, whole at every moment: they go to a temporary file in the
/// same folder, which is then renamed. A symbolic link stays, and the file behind it is replaced; a
/// device or pipe is written to directly. Throws OutputError with the path and the system's reason,
/// leaving an existing file as it was and no temporary file behind.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// Throws the OutputError with which writeFileAtomically would fail before its first byte: a
/// missing or unwritable folder, a folder or a write-protected file as target. Leaves nothing
/// behind and does not touch an existing file.
void checkWritable(const std::filesystem::path& path);

} // namespace calotype
