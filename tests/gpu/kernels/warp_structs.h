// What kernels/warp.comp gives back for a point of the unit square.
#ifndef CALOTYPE_TEST_WARP_STRUCTS_H
#define CALOTYPE_TEST_WARP_STRUCTS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

struct TestWarp {
    vec4 diskAndTriangle; ///< warpToDisk in xy, warpToTriangle in zw
    vec3 hemisphere;
    float pdf; ///< of `hemisphere`
};

CALOTYPE_END_SHARED

#endif
