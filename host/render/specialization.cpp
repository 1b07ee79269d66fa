#include "render/specialization.h"

#include "shared/specialization.h"

namespace calotype {

std::vector<uint32_t> specialization(const Device& device, const SceneFeatures& features,
                                     const std::optional<KernelTuning>& tuning, Sampler sampler,
                                     const TransportSettings& transport) {
    const DeviceInfo& info = device.info();
    const KernelTuning tuned = tuning.value_or(tuningFor(info));
    std::vector<uint32_t> constants(features.enabled.begin(), features.enabled.end());
    constants.resize(shared::kConstantCount);
    // The last column of the table uses these names: info, tuned, sampler, transport.
#define BEGIN_SETTINGS
#define SETTING(id, type, name, value, source) constants[shared::kConstant##id] = uint32_t{source};
#define END_SETTINGS
#include "shared/setting_table.h"
    return constants;
}

} // namespace calotype
