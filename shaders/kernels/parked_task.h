// Facts for the host about the tasks of kernels/path_trace.comp: how much memory they take.
#ifndef CALOTYPE_KERNELS_PARKED_TASK_H
#define CALOTYPE_KERNELS_PARKED_TASK_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

/// Pixels per lane: the current and the waiting one.
CALOTYPE_CONSTANT uint kTasksPerLane = 2;

#include "shared/declare_structs.h"

#include "kernels/parked_task_table.h"

CALOTYPE_END_SHARED

#endif
