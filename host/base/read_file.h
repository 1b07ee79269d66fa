#pragma once

#include <string>

namespace calotype {

/// The bytes of a file, which may be a pipe. Throws SceneError at `where` if it cannot be read; the
/// message names the file and the system's reason.
std::string readFile(const std::string& path, const std::string& where);

/// The bytes of standard input until its end. Throws SceneError at "standard input".
std::string readStandardInput();

/// Whether something can be opened for reading at `path`.
bool isReadableFile(const std::string& path);

} // namespace calotype
