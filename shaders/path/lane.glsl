// One lane of a subgroup that renders a tile: its pixel, the path that it follows there, and how
// they are put down and taken up again.
#ifndef CALOTYPE_PATH_LANE_GLSL
#define CALOTYPE_PATH_LANE_GLSL

#include "film/finite.glsl"
#include "path/path.glsl"
#include "shared/render_structs.h"

/// What a lane works at.
struct Lane {
    uint item; ///< its pixel, in the order of the tile
    bool hasPixel;
    bool hasPath;
    bool hasRay; ///< the path's, not yet on its way
    bool isOver; ///< the path, but its sample does not count yet
    Path path;
    vec4 sum; ///< of the pixel's radiance, and in w its samples
    uint raysEnded;
    uint pathsEnded;
    uint pathsCut;
    uint pathsLost; ///< that came out as no finite number
};

/// Adds the sample of a path that is over.
void endPath(inout Lane lane) {
    bool finite = isFinite(lane.path.radiance) && isFinite(lane.path.throughput);
    lane.sum += vec4(finite ? lane.path.radiance : vec3(0.0), 1.0);
    lane.pathsLost += finite ? 0u : 1u;
    lane.pathsEnded++;
    lane.hasPath = false;
}

/// The ray to a light is through: on with the path's own.
void settleShadow(inout Lane lane, Hit hit) {
    lane.raysEnded++;
    lane.hasRay = reachLight(lane.path, hit);
    lane.isOver = !lane.hasRay;
}

/// The path's ray is through: it meets what is there, or ends.
void meetSurface(inout Lane lane, Hit hit, PathLimits limits) {
    lane.raysEnded += lane.isOver ? 0u : 1u;
    lane.hasRay = !lane.isOver && extendPath(lane.path, hit, limits);
    lane.isOver = false;
    if (!lane.hasRay)
        endPath(lane);
}

ParkedPath park(Lane lane, uint nextItem) {
    Path path = lane.path;
    uint state = (lane.hasPath ? kLaneHasPath : 0u) | (path.isShadowed ? kLaneIsShadowed : 0u);
    return ParkedPath(path.ray.origin, path.ray.tMax, path.ray.direction, path.target, path.vertex,
                      path.bounce, path.throughput, path.bsdfPdf, path.radiance, state,
                      path.arriving, lane.item, path.direction, nextItem);
}

/// The path as it was put down, but for what names its random numbers.
Path unpark(ParkedPath parked, SampleId id) {
    Ray ray = Ray(parked.rayOrigin, parked.rayTMax, parked.rayDirection);
    return Path(id, ray, parked.vertex, parked.throughput, parked.radiance, parked.bounce,
                parked.bsdfPdf, (parked.state & kLaneIsShadowed) != 0u, parked.target,
                parked.arriving, parked.direction);
}

#endif
