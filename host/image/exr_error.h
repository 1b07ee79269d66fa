#pragma once

#include <exception>
#include <filesystem>
#include <string>

#include "base/error.h"

namespace calotype {

/// Returns what `read` returns; what OpenEXR throws becomes a SceneError at `path`.
template <typename Read>
auto withExrErrors(const std::filesystem::path& path, Read&& read) {
    try {
        return read();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw SceneError(path.string(),
                         std::string("the EXR file cannot be read: ") + error.what());
    }
}

} // namespace calotype
