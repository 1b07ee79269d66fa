// A library with the functions of Open Image Denoise 2 that the program calls, for tests where that
// is not installed. It takes the mean of 3 x 3 pixels, as far as their albedos are alike. What the
// environment variable FAKE_DENOISER names: "fails": every run fails; "slow": it takes 0.3 s.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <thread>

namespace {

struct Device {
    bool hasFailed = false;
};

struct Picture {
    float* pixels = nullptr;
    size_t width = 0;
    size_t height = 0;

    float* at(size_t x, size_t y) const { return pixels + 3 * (y * width + x); }
};

struct Filter {
    Device* device = nullptr;
    Picture color;
    Picture albedo;
    Picture normal;
    Picture output;
    bool hasCleanFeatures = false;
};

bool isToldTo(std::string_view what) {
    const char* told = std::getenv("FAKE_DENOISER");
    return told && told == what;
}

bool isAlike(const Filter& filter, size_t x, size_t y, size_t u, size_t v) {
    if (!filter.albedo.pixels || !filter.normal.pixels)
        return true;
    const float most = filter.hasCleanFeatures ? 0.05f : 0.5f;
    for (int i = 0; i < 3; ++i)
        if (std::abs(filter.albedo.at(x, y)[i] - filter.albedo.at(u, v)[i]) > most)
            return false;
    return true;
}

void filterPixel(const Filter& filter, size_t x, size_t y) {
    const Picture& color = filter.color;
    float sum[3] = {};
    float count = 0.0f;
    for (size_t v = y > 0 ? y - 1 : 0; v < color.height && v <= y + 1; ++v)
        for (size_t u = x > 0 ? x - 1 : 0; u < color.width && u <= x + 1; ++u) {
            if (!isAlike(filter, x, y, u, v))
                continue;
            for (int i = 0; i < 3; ++i)
                sum[i] += color.at(u, v)[i];
            ++count;
        }
    for (int i = 0; i < 3; ++i)
        filter.output.at(x, y)[i] = sum[i] / count;
}

} // namespace

extern "C" {

Device* oidnNewDevice(int) { return new Device; }
void oidnSetDeviceInt(Device*, const char*, int) {}
int oidnGetDeviceInt(Device*, const char* name) { return !std::strcmp(name, "versionMajor") * 2; }
void oidnCommitDevice(Device*) {}
int oidnGetDeviceError(Device* device, const char** message) {
    *message = "it was told to";
    const bool hasFailed = device->hasFailed;
    device->hasFailed = false;
    return hasFailed ? 1 : 0;
}
void oidnReleaseDevice(Device* device) { delete device; }
Filter* oidnNewFilter(Device* device, const char*) { return new Filter{device, {}, {}, {}, {}}; }
void oidnSetSharedFilterImage(Filter* filter, const char* name, void* pixels, int, size_t width,
                              size_t height, size_t, size_t, size_t) {
    const std::string_view which = name;
    Picture& picture = which == "color"    ? filter->color
                       : which == "albedo" ? filter->albedo
                       : which == "normal" ? filter->normal
                                           : filter->output;
    picture = {static_cast<float*>(pixels), width, height};
}
void oidnSetFilterBool(Filter* filter, const char* name, bool value) {
    if (!std::strcmp(name, "cleanAux"))
        filter->hasCleanFeatures = value;
}
void oidnSetFilterInt(Filter*, const char*, int) {}
void oidnSetFilterFloat(Filter*, const char*, float) {}
void oidnCommitFilter(Filter*) {}
void oidnExecuteFilter(Filter* filter) {
    if (isToldTo("slow"))
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
    filter->device->hasFailed = isToldTo("fails");
    for (size_t y = 0; y < filter->color.height; ++y)
        for (size_t x = 0; x < filter->color.width; ++x)
            filterPixel(*filter, x, y);
}
void oidnReleaseFilter(Filter* filter) { delete filter; }

} // extern "C"
