#include "accel/build_bvh.h"

#include "accel/collapse.h"
#include "accel/median_split.h"
#include "accel/sah_split.h"
#include "shared/limits.h"

namespace calotype {

Bvh buildBvh(std::span<const Primitive> primitives, BvhBuilder builder,
             const BuildOptions& options) {
    if (builder == BvhBuilder::Sah) {
        Bvh bvh = collapse(buildSahSplit(primitives, options), primitives, options.threads);
        if (bvh.depth <= gpu::kMaxBvhDepth)
            return bvh; // nearly always: a tree must be very lopsided to be deeper
    }
    return collapse(buildMedianSplit(primitives, options), primitives, options.threads);
}

} // namespace calotype
