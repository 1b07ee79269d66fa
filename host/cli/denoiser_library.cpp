#include "cli/denoiser_library.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include "denoise/oidn_library.h"

namespace calotype {
namespace {

namespace fs = std::filesystem;

/// The path in an environment variable; empty if it is not set.
fs::path pathIn(const char* variable) {
    const char* value = std::getenv(variable);
    return value ? value : "";
}

/// The folders "python3*" in a folder.
std::vector<fs::path> pythonsIn(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().filename().string().starts_with("python3"))
            found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

std::vector<fs::path> foldersOfPython() {
    std::vector<fs::path> roots;
    if (const fs::path environment = pathIn("VIRTUAL_ENV"); !environment.empty())
        roots.push_back(environment / "lib");
    if (const fs::path home = pathIn("HOME"); !home.empty())
        roots.push_back(home / ".local/lib");
    roots.insert(roots.end(), {"/usr/local/lib", "/usr/lib"});
    return roots;
}

} // namespace

std::string denoiserLibrary() {
    if (const fs::path named = pathIn("CALOTYPE_OIDN"); !named.empty())
        return named.string();
    std::error_code ignored;
    if (fs::exists(oidnFile(oidnFolder()), ignored))
        return "";
    for (const fs::path& root : foldersOfPython())
        for (const fs::path& python : pythonsIn(root))
            for (const char* packages : {"site-packages", "dist-packages"})
                if (const fs::path folder = python / packages / "pyoidn/oidn/lib";
                    fs::exists(oidnFile(folder), ignored))
                    return folder.string();
    return "";
}

} // namespace calotype
