// The state of a light path between two of its rays.
#ifndef CALOTYPE_PATH_PATH_STATE_GLSL
#define CALOTYPE_PATH_PATH_STATE_GLSL

#include "config/sampler.glsl"
#include "config/settings.glsl"
#include "core/select.glsl"
#include "film/film_filter.glsl"
#include "lights/light.glsl"
#include "path/camera.glsl"

// The purpose of the path's ray.
const uint kPathRay = 0u;   ///< finds the next surface of the path
const uint kShadowRay = 1u; ///< finds whether light arrives at the path's vertex
const uint kHiddenRay = 2u; ///< has left the scene from the camera: its sample shows nothing

struct Path {
    SampleId id;
#define ROW(type, name, words) type name;
#define FIELD(type, name, words) type name;
#include "path/path_fields.h"
#undef ROW
#undef FIELD
};

struct PathLimits {
    uint maxBounces;
    float indirectClamp; ///< as in RenderParameters
    SceneLights lights;
};

Ray pathRay(Path path) { return Ray(path.rayOrigin, path.rayTMax, path.rayDirection); }

bool hasShadowRay(Path path) { return hasLights && path.rayKind == kShadowRay; }

/// True after the path's end if it shows the background, which is hidden from the camera.
bool showsNothing(Path path) { return hidesBackground && path.rayKind == kHiddenRay; }

void setRay(inout Path path, Ray ray, uint kind, uint target) {
    path.rayOrigin = ray.origin;
    path.rayTMax = ray.tMax;
    path.rayDirection = ray.direction;
    path.rayKind = kind;
    path.target = target;
}

Path startPath(SampleId id, Camera camera, uvec2 imageSize) {
    vec4 u = samplerNumbers(id, kDimensionCamera);
    vec2 filmPosition = vec2(id.pixel) + sampleFilm(camera, u.xy);
    Ray ray = cameraRay(camera, filmPosition, imageSize, u.zw);
    Path path;
    path.id = id;
    setRay(path, ray, kPathRay, kNone);
    path.vertex = ray.origin;
    path.bounce = 0u;
    path.throughput = vec3(1.0);
    path.bsdfPdf = 0.0;
    path.radiance = vec3(0.0);
    path.etaScale = 1.0;
    path.arriving = vec3(0.0);
    path.nextDirection = vec3(0.0);
    return path;
}

/// Sends the path on from its vertex. False if the throughput is zero.
bool leaveVertex(inout Path path) {
    setRay(path, Ray(path.vertex, kFar, path.nextDirection), kPathRay, kNone);
    return greatest(path.throughput) > 0.0;
}

/// Adds light that the path found.
void addRadiance(inout Path path, vec3 found, PathLimits limits) {
    if (clampsIndirect && path.bounce >= 2u) {
        float most = greatest(found);
        found *= most > limits.indirectClamp ? limits.indirectClamp / most : 1.0;
    }
    path.radiance += found;
}

#endif
