// Lists of rays, which are traced without any shading.
#ifndef CALOTYPE_SHARED_RAY_STRUCTS_H
#define CALOTYPE_SHARED_RAY_STRUCTS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

CALOTYPE_CONSTANT uint kRaysPerGroup = 256;

#include "shared/declare_structs.h"
#include "shared/ray_struct_table.h"

CALOTYPE_END_SHARED

#endif
