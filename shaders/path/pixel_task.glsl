// What a lane of a subgroup works at when it renders a tile: a pixel and the path that it follows
// there, and how they are put down and taken up again.
#ifndef CALOTYPE_PATH_PIXEL_TASK_GLSL
#define CALOTYPE_PATH_PIXEL_TASK_GLSL

#include "film/finite.glsl"
#include "path/path.glsl"
#include "shared/render_structs.h"

/// A pixel and its path.
struct PixelTask {
    uint item; ///< the pixel, in the order of the tile
    bool hasPixel;
    bool hasPath;
    bool hasRay; ///< the path's, not yet on its way
    bool isOver; ///< the path, but its sample does not count yet
    Path path;
    Hit hit;  ///< of the ray, once it is through
    vec4 sum; ///< of the pixel's radiance, and in w its samples
};

/// What a lane did in this dispatch.
struct LaneTotals {
    uint raysEnded;
    uint pathsEnded;
    uint pathsCut;
    uint pathsLost; ///< that came out as no finite number
};

/// Adds the sample of a path that is over.
void endPath(inout PixelTask task, inout LaneTotals totals) {
    bool finite = isFinite(task.path.radiance) && isFinite(task.path.throughput);
    task.sum += vec4(finite ? task.path.radiance : vec3(0.0), 1.0);
    totals.pathsLost += finite ? 0u : 1u;
    totals.pathsEnded++;
    task.hasPath = false;
}

/// The ray to a light is through: on with the path's own.
void settleShadow(inout PixelTask task, PathLimits limits, inout LaneTotals totals) {
    totals.raysEnded++;
    task.hasRay = reachLight(task.path, task.hit, limits);
    task.isOver = !task.hasRay;
}

/// The path's ray is through: it meets what is there, or ends.
void meetSurface(inout PixelTask task, PathLimits limits, inout LaneTotals totals) {
    totals.raysEnded += task.isOver ? 0u : 1u;
    task.hasRay = !task.isOver && extendPath(task.path, task.hit, limits);
    task.isOver = false;
    if (!task.hasRay)
        endPath(task, totals);
}

void swapTasks(inout PixelTask a, inout PixelTask b) {
    PixelTask first = a;
    a = b;
    b = first;
}

ParkedPath park(PixelTask task, uint nextItem) {
    Path path = task.path;
    uint state = (task.hasPath ? kTaskHasPath : 0u) | (path.isShadowed ? kTaskIsShadowed : 0u);
    return ParkedPath(path.ray.origin, path.ray.tMax, path.ray.direction, path.target, path.vertex,
                      path.bounce, path.throughput, path.bsdfPdf, path.radiance, path.etaScale,
                      path.arriving, task.item | state, path.direction, nextItem);
}

/// The path as it was put down, but for what names its random numbers.
Path unpark(ParkedPath parked, SampleId id) {
    Ray ray = Ray(parked.rayOrigin, parked.rayTMax, parked.rayDirection);
    return Path(id, ray, parked.vertex, parked.throughput, parked.radiance, parked.bounce,
                parked.bsdfPdf, parked.etaScale, (parked.item & kTaskIsShadowed) != 0u,
                parked.target, parked.arriving, parked.direction);
}

#endif
