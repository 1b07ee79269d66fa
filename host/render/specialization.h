#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gpu/device.h"
#include "pack/scene_features.h"
#include "render/kernel_tuning.h"
#include "settings/sampler.h"
#include "settings/transport.h"

namespace calotype {

/// The specialization constants of a kernel, indexed by the identifiers in shared/specialization.h.
/// Without a tuning, the one for the kind of device is used.
std::vector<uint32_t> specialization(const Device& device, const SceneFeatures& features,
                                     const std::optional<KernelTuning>& tuning = std::nullopt,
                                     Sampler sampler = Sampler::Independent,
                                     const TransportSettings& transport = {});

} // namespace calotype
