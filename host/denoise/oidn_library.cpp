#include "denoise/oidn_library.h"

#include <system_error>
#include <type_traits>
#include <vector>

#include <dlfcn.h>

#include "base/error.h"

namespace calotype {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFileName = "libOpenImageDenoise.so.2";
constexpr const char* kAdvice = "; ./bootstrap gets it, or: pip install pyoidn; the command line "
                                "also takes it from CALOTYPE_OIDN";

} // namespace

fs::path oidnFile(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored) ? path / kFileName : path;
}

fs::path oidnFolder() {
    std::error_code ignored;
    return fs::read_symlink("/proc/self/exe", ignored).parent_path() / "oidn/lib";
}

OidnLibrary::OidnLibrary(const fs::path& path) {
    // The linker finds a name without a folder in the system.
    const std::vector<fs::path> files =
        path.empty() ? std::vector<fs::path>{oidnFolder() / kFileName, kFileName}
                     : std::vector<fs::path>{oidnFile(path)};
    std::string problem;
    for (const fs::path& candidate : files) {
        path_ = candidate.string();
        handle_ = dlopen(path_.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (handle_)
            break;
        const std::string reason = dlerror();
        std::error_code ignored;
        if (files.size() == 1 || fs::exists(candidate, ignored))
            problem += " (" + reason + ")";
    }
    if (!handle_)
        throw SettingError("denoise", "needs Open Image Denoise 2, which cannot be loaded" +
                                          problem + kAdvice);
    bool isVersion2 = true;
    const auto load = [&](const char* name, auto& function) {
        // POSIX lets an object pointer of dlsym become a function pointer.
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle_, name));
        isVersion2 = isVersion2 && function;
    };
    load("oidnNewDevice", newDevice);
    load("oidnSetDeviceInt", setDeviceInt);
    load("oidnGetDeviceInt", getDeviceInt);
    load("oidnCommitDevice", commitDevice);
    load("oidnGetDeviceError", getDeviceError);
    load("oidnReleaseDevice", releaseDevice);
    load("oidnNewFilter", newFilter);
    load("oidnSetSharedFilterImage", setSharedFilterImage);
    load("oidnSetFilterBool", setFilterBool);
    load("oidnSetFilterInt", setFilterInt);
    load("oidnSetFilterFloat", setFilterFloat);
    load("oidnCommitFilter", commitFilter);
    load("oidnExecuteFilter", executeFilter);
    load("oidnReleaseFilter", releaseFilter);
    if (!isVersion2) {
        dlclose(handle_);
        throw SettingError("denoise", "needs Open Image Denoise 2, and '" + path_ +
                                          "' lacks functions of it" + kAdvice);
    }
}

OidnLibrary::~OidnLibrary() { dlclose(handle_); }

} // namespace calotype
