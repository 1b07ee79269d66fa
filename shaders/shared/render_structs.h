// The inputs of a dispatch of a rendering kernel, and its results.
#ifndef CALOTYPE_SHARED_RENDER_STRUCTS_H
#define CALOTYPE_SHARED_RENDER_STRUCTS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

#include "shared/declare_structs.h"
#include "shared/render_struct_table.h"

CALOTYPE_END_SHARED

#endif
