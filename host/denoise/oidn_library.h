#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace calotype {

/// Open Image Denoise 2 (https://www.openimagedenoise.org), loaded at run time: a user without it
/// needs no other build. Only the functions of its C interface that the denoiser calls.
class OidnLibrary {
public:
    struct Device; ///< of the library
    struct Filter; ///< of the library

    // Values of its C interface.
    static constexpr int kCpuDevice = 1;
    static constexpr int kNoError = 0;
    static constexpr int kFloat3 = 3;
    static constexpr int kHighQuality = 6;

    /// Loads the library from `path`, which is its file or its folder; if that is empty, from the
    /// folder "oidn/lib" beside the program, or else from the system. Throws SettingError with what
    /// to do if it is not there, or not of version 2.
    explicit OidnLibrary(const std::filesystem::path& path);
    ~OidnLibrary();
    OidnLibrary(const OidnLibrary&) = delete;
    OidnLibrary& operator=(const OidnLibrary&) = delete;

    /// Where it was found, for messages.
    const std::string& path() const { return path_; }

    Device* (*newDevice)(int type) = nullptr;
    void (*setDeviceInt)(Device* device, const char* name, int value) = nullptr;
    int (*getDeviceInt)(Device* device, const char* name) = nullptr;
    void (*commitDevice)(Device* device) = nullptr;
    int (*getDeviceError)(Device* device, const char** message) = nullptr;
    void (*releaseDevice)(Device* device) = nullptr;
    Filter* (*newFilter)(Device* device, const char* type) = nullptr;
    void (*setSharedFilterImage)(Filter* filter, const char* name, void* pixels, int format,
                                 size_t width, size_t height, size_t byteOffset,
                                 size_t pixelByteStride, size_t rowByteStride) = nullptr;
    void (*setFilterBool)(Filter* filter, const char* name, bool value) = nullptr;
    void (*setFilterInt)(Filter* filter, const char* name, int value) = nullptr;
    void (*setFilterFloat)(Filter* filter, const char* name, float value) = nullptr;
    void (*commitFilter)(Filter* filter) = nullptr;
    void (*executeFilter)(Filter* filter) = nullptr;
    void (*releaseFilter)(Filter* filter) = nullptr;

private:
    std::string path_;
    void* handle_ = nullptr;
};

/// The library's file in a folder, if `path` is one; else `path`.
std::filesystem::path oidnFile(const std::filesystem::path& path);

/// The folder "oidn/lib" beside the program.
std::filesystem::path oidnFolder();

} // namespace calotype
