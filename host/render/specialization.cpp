#include "render/specialization.h"

namespace calotype {

std::vector<uint32_t> specialization(const Device& device, const SceneFeatures& features,
                                     const std::optional<KernelTuning>& tuning, Sampler sampler,
                                     const TransportSettings& transport) {
    const KernelTuning tuned = tuning.value_or(tuningFor(device.info()));
    std::vector<uint32_t> constants(features.enabled.begin(), features.enabled.end());
    constants.resize(gpu::kConstantCount);
    constants[gpu::kConstantSubgroupSize] = device.info().subgroupSize;
    constants[gpu::kConstantNodeEighths] = tuned.nodeEighths;
    constants[gpu::kConstantPrimitiveEighths] = tuned.primitiveEighths;
    constants[gpu::kConstantRayEighths] = tuned.rayEighths;
    constants[gpu::kConstantEventEighths] = tuned.eventEighths;
    constants[gpu::kConstantSharesStack] = tuned.sharesStack ? 1 : 0;
    constants[gpu::kConstantSobol] = sampler == Sampler::Sobol ? 1 : 0;
    constants[gpu::kConstantMis] = transport.usesMis ? 1 : 0;
    constants[gpu::kConstantRoulette] = transport.usesRoulette ? 1 : 0;
    constants[gpu::kConstantClampsIndirect] = transport.clampsIndirect() ? 1 : 0;
    return constants;
}

} // namespace calotype
