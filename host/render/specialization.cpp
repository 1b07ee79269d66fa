#include "render/specialization.h"

namespace calotype {

std::vector<uint32_t> specialization(const Device& device, const SceneFeatures& features,
                                     const std::optional<KernelTuning>& wish, Sampler sampler) {
    const KernelTuning tuning = wish.value_or(tuningFor(device.info()));
    std::vector<uint32_t> constants(features.enabled.begin(), features.enabled.end());
    constants.resize(gpu::kConstantCount);
    constants[gpu::kConstantSubgroupSize] = device.info().subgroupSize;
    constants[gpu::kConstantNodeEighths] = tuning.nodeEighths;
    constants[gpu::kConstantPrimitiveEighths] = tuning.primitiveEighths;
    constants[gpu::kConstantRayEighths] = tuning.rayEighths;
    constants[gpu::kConstantEventEighths] = tuning.eventEighths;
    constants[gpu::kConstantSharesStack] = tuning.sharesStack ? 1 : 0;
    constants[gpu::kConstantSobol] = sampler == Sampler::Sobol ? 1 : 0;
    return constants;
}

} // namespace calotype
