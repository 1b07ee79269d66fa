#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/error.h"
#include "denoise/oidn_library.h"
#include "support/paths.h"
#include "support/program.h"

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

/// Options of a program whose denoiser is the library of tests/support/denoiser. `told` is empty,
/// or what it shall do: "fails" or "slow".
inline ProgramOptions withFakeDenoiser(const std::string& told = "") {
    ProgramOptions options;
    options.environment["CALOTYPE_OIDN"] = kFakeDenoiser;
    options.environment["FAKE_DENOISER"] = told;
    return options;
}

} // namespace calotype::test
