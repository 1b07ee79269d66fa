#pragma once

#include "scene/scene.h"
#include "support/agreement.h"

namespace calotype::test {

/// A square picture that the device made of one scene, held to another's, which should look alike.
struct PictureAgreement {
    PairedDifference paired;      ///< from the same random numbers
    Agreement independent;        ///< from others
    double differingShare = 0.0;  ///< of the pixels whose first samples differ by more than 1e-3
    glm::dvec3 meanRadiance{0.0}; ///< of the other's picture
};

/// The device's picture against the reference tracer's, of `expected`. Fails the test where a
/// sample is not finite or a path is cut.
PictureAgreement agreementWithReference(const Scene& scene, const Scene& expected, uint32_t side,
                                        size_t blocks);

/// The t-tests pass; the paired means differ by `bound` of the reference's and
/// five standard errors at most, and `mostDiffering` of the pixels. Prints what was seen.
void expectAgreement(const PictureAgreement& agreement, double bound, double mostDiffering);

} // namespace calotype::test
