#include "image/features.h"

#include <limits>

namespace calotype {

Features meanFeatures(const Features& sum, uint32_t rays) {
    const float share = 1.0f / static_cast<float>(rays);
    Features mean;
    mean.meanAlbedo = share * sum.meanAlbedo;
    mean.meanNormal = share * sum.meanNormal;
    mean.meanDepth =
        sum.alpha > 0.0f ? sum.meanDepth / sum.alpha : std::numeric_limits<float>::infinity();
    mean.alpha = share * sum.alpha;
    return mean;
}

void add(const Features& ray, Features& sum) {
#define CALOTYPE_ADD(name, type, channels, help) sum.name += ray.name;
    CALOTYPE_AVERAGED_LAYERS(CALOTYPE_ADD)
#undef CALOTYPE_ADD
}

} // namespace calotype
