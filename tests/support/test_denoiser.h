#pragma once

#include <filesystem>
#include <memory>

#include "base/error.h"
#include "denoise/oidn_library.h"
#include "support/paths.h"

namespace calotype::test {

/// Open Image Denoise beside the program under test, where ./bootstrap puts it, or of the system.
/// Null where there is none: tests that need it are skipped.
inline std::unique_ptr<const OidnLibrary> testDenoiser() {
    const auto file = oidnFile(std::filesystem::path(kProgram).parent_path() / "oidn/lib");
    try {
        return std::make_unique<const OidnLibrary>(exists(file) ? file : "");
    } catch (const SettingError&) {
        return nullptr;
    }
}

} // namespace calotype::test
