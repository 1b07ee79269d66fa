// The task of a lane when it renders a tile: a pixel and its current path. Tasks are parked between
// dispatches.
#ifndef CALOTYPE_KERNELS_PIXEL_TASK_GLSL
#define CALOTYPE_KERNELS_PIXEL_TASK_GLSL

#include "film/finite.glsl"
#include "kernels/parked_task.h"
#include "path/path.glsl"

/// A pixel and its path.
struct PixelTask {
    uint item; ///< the pixel, in the order of the tile
    bool hasPixel;
    bool hasPath;
    bool hasRay; ///< the path's next ray has not been started yet
    bool isOver; ///< the path has ended, but its sample is not in `sum` yet
    Path path;
    Hit hit;  ///< of the path's ray, after it has been traced
    vec4 sum; ///< of the pixel's radiance, and in w its samples (kHiddenSample)
};

/// The results of a lane in this dispatch.
struct LaneTotals {
    uint raysEnded;
    uint pathsEnded;
    uint pathsCut;
    uint pathsLost; ///< samples that are not finite
};

/// Adds the sample of a path that has ended.
void endPath(inout PixelTask task, inout LaneTotals totals) {
    bool finite = isFinite(task.path.radiance) && isFinite(task.path.throughput);
    float count = showsNothing(task.path) ? 1.0 + kHiddenSample : 1.0;
    task.sum += vec4(finite ? task.path.radiance : vec3(0.0), count);
    totals.pathsLost += finite ? 0u : 1u;
    totals.pathsEnded++;
    task.hasPath = false;
}

/// Call when the shadow ray has been traced and hit nothing transparent: the path takes its step.
void settleShadow(inout PixelTask task, PathLimits limits, inout LaneTotals totals) {
    totals.raysEnded++;
    task.hasRay = pathShadow(task.path, task.hit.primitive == kNone, limits);
    task.isOver = !task.hasRay;
}

/// Call when the path's ray has been traced or the path has ended: takes its step, or ends it.
void stepTask(inout PixelTask task, PathLimits limits, inout LaneTotals totals) {
    totals.raysEnded += task.isOver ? 0u : 1u;
    task.hasRay = !task.isOver && stepPath(task.path, task.hit, limits);
    task.isOver = false;
    if (!task.hasRay)
        endPath(task, totals);
}

void swapTasks(inout PixelTask a, inout PixelTask b) {
    PixelTask first = a;
    a = b;
    b = first;
}

ParkedTask park(PixelTask task, uint nextItem) {
    ParkedTask parked;
#define ROW(type, name, words) parked.name = task.path.name;
#define FIELD(type, name, words) parked.name = task.path.name;
#include "path/path_fields.h"
#undef ROW
#undef FIELD
    parked.item = task.item;
    parked.hasPath = task.hasPath ? 1u : 0u;
    parked.nextItem = nextItem;
    parked.pad0 = 0u;
    parked.pad1 = 0u;
    return parked;
}

/// The path as it was parked; `id` is not parked.
Path unpark(ParkedTask parked, SampleId id) {
    Path path;
    path.id = id;
#define ROW(type, name, words) path.name = parked.name;
#define FIELD(type, name, words) path.name = parked.name;
#include "path/path_fields.h"
#undef ROW
#undef FIELD
    return path;
}

#endif
