// Votes among the lanes of a subgroup.
#ifndef CALOTYPE_KERNELS_LANES_GLSL
#define CALOTYPE_KERNELS_LANES_GLSL

/// The number of active lanes where the condition holds.
uint lanesWhere(bool condition) { return subgroupBallotBitCount(subgroupBallot(condition)); }

/// Whether the condition holds in at least `eighths` eighths of `lanesAtWork` lanes, and in one.
bool areEnough(bool condition, uint eighths, uint lanesAtWork) {
    return 8u * lanesWhere(condition) >= max(eighths * lanesAtWork, 1u);
}

#endif
