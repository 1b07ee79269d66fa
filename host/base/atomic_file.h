#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace calotype {

/// Replaces the file `path` by `bytes`, atomically: they are written to a temporary file in the
/// same folder, which is then renamed. A symbolic link stays, and its target is replaced, or made;
/// a device or pipe is written directly. A replaced file keeps its mode and its extended
/// attributes, and its owner and group where the system allows that; without its group, it loses
/// the rights of the group. On failure, throws OutputError with the path and the system's
/// reason, an existing file is unchanged, and no temporary file is left.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// The same with the bytes in pieces, one after the other.
void writeFileAtomically(const std::filesystem::path& path,
                         std::span<const std::string_view> pieces);

/// Throws the OutputError that writeFileAtomically would throw before its first byte: a missing or
/// unwritable folder, a folder or a write-protected file as target. Leaves no file, and does not
/// change an existing one.
void checkWritable(const std::filesystem::path& path);

/// The file that is written if `path` is an output: after symbolic links, as an absolute path where
/// its folder exists.
std::filesystem::path outputTarget(const std::filesystem::path& path);

/// A hidden file of this program beside `target`: its name is that of `target` and `ending`.
std::filesystem::path fileBeside(const std::filesystem::path& target, const std::string& ending);

/// Removes the temporary files that processes which were killed left beside `target`. Nobody may be
/// writing `target` (base/output_lock.h).
void removeLeftovers(const std::filesystem::path& target);

} // namespace calotype
