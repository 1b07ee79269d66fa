#pragma once

#include <cstdint>
#include <optional>

#include "scene/scene.h"
#include "settings/light_choice.h"
#include "support/agreement.h"
#include "support/statistics.h"

namespace calotype::test {

/// One scene by the device and by the reference tracer, from the same random numbers.
struct Judgement {
    Estimate device; ///< mean of the picture's first channel, over its blocks of samples
    Estimate reference;
    Estimate difference; ///< device - reference, block by block
};

/// A square picture of `side` pixels, a multiple of 8. The scene's own film size does not count.
/// Fails the test where a sample is not finite or a path is cut. Lights are chosen as usual in the
/// scene, unless `choice` is given.
Judgement judge(const Scene& scene, uint32_t side, size_t blocks,
                std::optional<LightChoice> choice = {});

/// The means are equal but for `bound` of the reference's, and for the noise
/// of the few paths that part: five standard errors of the paired difference.
void expectJudgement(const Judgement& judgement, double bound);

} // namespace calotype::test
