#include "render/specialization.h"

#include <cstdlib>
namespace calotype {

std::vector<uint32_t> specialization(const Device& device, const SceneFeatures& features,
                                     const KernelTuning& tuning) {
    std::vector<uint32_t> constants(features.enabled.begin(), features.enabled.end());
    constants.resize(gpu::kConstantCount);
    constants[gpu::kConstantSubgroupSize] = device.info().subgroupSize;
    constants[gpu::kConstantNodeEighths] = getenv("N") ? atoi(getenv("N")) : tuning.nodeEighths;
    constants[gpu::kConstantPrimitiveEighths] =
        getenv("T") ? atoi(getenv("T")) : tuning.primitiveEighths;
    constants[gpu::kConstantPathEighths] = getenv("A") ? atoi(getenv("A")) : tuning.pathEighths;
    return constants;
}

} // namespace calotype
