#include "engine/denoising_memory.h"

#include <algorithm>
#include <cstdio>

#include "base/available_memory.h"
#include "base/error.h"
#include "denoise/cross_validation.h"
#include "shared/limits.h"

namespace calotype {
namespace {

// Bytes per pixel, measured. Of a film: its sums, the features, and the device's part of the
// picture, which is this machine's memory on lavapipe.
constexpr uint64_t kFilm = 110;
constexpr uint64_t kFilmReplica = 30;
/// An adaptive film has sums of its own for each half, and numbers of samples in each pixel.
constexpr uint64_t kAdaptive = 80;
// Of denoising: pictures and features; with replicas, planes of numbers.
constexpr uint64_t kPictures = 100;
constexpr uint64_t kPlanes = 60;
constexpr uint64_t kReplica = 20;
constexpr uint64_t kStatistical = 120;
constexpr uint64_t kOidn = 760;
/// OidnDenoiser::kMostMegabytes, and what the library takes beside.
constexpr uint64_t kMostOidnBytes = 1'200'000'000;

double gigabytes(uint64_t bytes) { return 1e-9 * static_cast<double>(bytes); }

} // namespace

uint64_t denoisingBytes(DenoiserKind kind, uint64_t pixels, uint64_t replicas) {
    const uint64_t crossValidation = replicas >= kLeastReplicas ? kPlanes + kReplica * replicas : 0;
    const uint64_t own = (kPictures + crossValidation) * pixels;
    if (kind == DenoiserKind::Oidn)
        return own + std::min(kOidn * pixels, kMostOidnBytes);
    return own + kStatistical * pixels;
}

std::string whyNoRoom(uint64_t bytes, uint64_t available) {
    if (bytes <= available)
        return "";
    char text[100];
    std::snprintf(text, sizeof text, "needs about %.1f GB of memory, and %.1f GB are available",
                  gigabytes(bytes), gigabytes(available));
    return text;
}

void requireDenoisingMemory(const RenderSettings& settings, uint64_t blocks) {
    if (settings.denoiser == DenoiserKind::Off)
        return;
    const uint64_t pixels = uint64_t{settings.crop.width} * settings.crop.height;
    const uint64_t replicas = std::min<uint64_t>(blocks, shared::kReplicas);
    const uint64_t ofKind = kFilm + (settings.isAdaptive ? kAdaptive : 0);
    const uint64_t bytes = (ofKind + kFilmReplica * replicas) * pixels +
                           denoisingBytes(settings.denoiser, pixels, replicas);
    if (const std::string why = whyNoRoom(bytes, availableMemory()); !why.empty())
        throw SettingError("denoise", why + ", for a picture of " +
                                          std::to_string(settings.crop.width) + " x " +
                                          std::to_string(settings.crop.height) +
                                          " pixels; render a smaller one, or without --denoise");
}

} // namespace calotype
