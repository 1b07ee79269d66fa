#include "render/specialization.h"

#include "shared/specialization.h"

namespace calotype {

std::vector<uint32_t> specialization(const Device& device, const SceneFeatures& features,
                                     const std::optional<KernelTuning>& tuning, Sampler sampler,
                                     const TransportSettings& transport) {
    const KernelTuning tuned = tuning.value_or(tuningFor(device.info()));
    std::vector<uint32_t> constants(features.enabled.begin(), features.enabled.end());
    constants.resize(shared::kConstantCount);
    constants[shared::kConstantSubgroupSize] = device.info().subgroupSize;
    constants[shared::kConstantNodeEighths] = tuned.nodeEighths;
    constants[shared::kConstantPrimitiveEighths] = tuned.primitiveEighths;
    constants[shared::kConstantRayEighths] = tuned.rayEighths;
    constants[shared::kConstantEventEighths] = tuned.eventEighths;
    constants[shared::kConstantSharesStack] = tuned.sharesStack ? 1 : 0;
    constants[shared::kConstantSobol] = sampler == Sampler::Sobol ? 1 : 0;
    constants[shared::kConstantMis] = transport.usesMis ? 1 : 0;
    constants[shared::kConstantRoulette] = transport.usesRoulette ? 1 : 0;
    constants[shared::kConstantClampsIndirect] = transport.clampsIndirect() ? 1 : 0;
    return constants;
}

} // namespace calotype
