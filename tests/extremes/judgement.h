#pragma once

#include <cstdint>

#include "scene/scene.h"
#include "support/agreement.h"
#include "support/statistics.h"

namespace calotype::test {

/// What a rendering counted.
struct Counted {
    uint64_t paths = 0;
    uint64_t nonFiniteSamples = 0;
    uint64_t cutPaths = 0;
};

/// One scene by the device and by the reference tracer, from the same random numbers.
struct Judgement {
    Estimate device; ///< mean of the picture's first channel, over its blocks of samples
    Estimate reference;
    Estimate difference; ///< device - reference, block by block
    Counted counted;     ///< by the device
};

/// A square picture of `side` pixels, a multiple of 8. The scene's own film size does not count.
Judgement judge(const Scene& scene, uint32_t side, size_t blocks);

/// Nothing was lost, and the means are equal but for `bound` of the reference's, and for the noise
/// of the few paths that part: five standard errors of the paired difference.
void expectJudgement(const Judgement& judgement, double bound);

} // namespace calotype::test
