#pragma once

#include <cstdint>
#include <string>

#include "settings/denoiser_kind.h"
#include "settings/render_settings.h"

namespace calotype {

/// Bytes of this machine's memory that it takes to denoise a film of so many pixels and replicas,
/// besides the film, about (docs/limitations.md).
uint64_t denoisingBytes(DenoiserKind kind, uint64_t pixels, uint64_t replicas);

/// "needs about 12.5 GB of memory, and 8.0 GB are available"; empty if `bytes` are at most
/// `available`.
std::string whyNoRoom(uint64_t bytes, uint64_t available);

/// Throws SettingError, with what to do, if this machine has too little memory to render and
/// denoise the picture of the settings, whose film has so many blocks in the end.
void requireDenoisingMemory(const RenderSettings& settings, uint64_t blocks);

} // namespace calotype
