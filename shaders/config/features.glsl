// The features that the scene needs. All default to true: specialization only removes code.
#ifndef CALOTYPE_CONFIG_FEATURES_GLSL
#define CALOTYPE_CONFIG_FEATURES_GLSL

#include "shared/scene_structs.h"
#include "shared/specialization.h"

#define BEGIN_FEATURES
#define FEATURE(id, people) layout(constant_id = kFeature##id) const bool has##id = true;
#define END_FEATURES
#include "shared/feature_table.h"

const bool hasQuadrics = hasSpheres || hasCylinders || hasCones || hasDisks;
const bool hasFewQuadrics = hasTriangles && hasQuadrics && !hasManyQuadrics;
const bool hasShadingNormals = hasSmoothNormals || hasNormalMaps;

// The number of kinds of lights that there may be, by their sort.
#define BEGIN_FEATURES const uint kAreaKinds = 0u
#define LIGHT(id, sort, people) +(has##id##Lights && kSort##sort == kSortArea ? 1u : 0u)
#define END_FEATURES ;
#include "shared/feature_table.h"
#define BEGIN_FEATURES const uint kUniformQuadricKinds = 0u
#define LIGHT(id, sort, people) +(has##id##Lights && kSort##sort == kSortUniformQuadric ? 1u : 0u)
#define END_FEATURES ;
#include "shared/feature_table.h"
#define BEGIN_FEATURES const uint kInfiniteKinds = 0u
#define LIGHT(id, sort, people) +(has##id##Lights && kSort##sort == kSortInfinite ? 1u : 0u)
#define END_FEATURES ;
#include "shared/feature_table.h"
const bool hasUniformQuadricLights = kUniformQuadricKinds > 0u;
const bool hasQuadricLights = hasSphereLights || hasUniformQuadricLights;
const bool hasFiniteLights = kAreaKinds > 0u || hasUniformQuadricLights;
const bool hasInfiniteLights = kInfiniteKinds > 0u;
const bool hasLights = hasFiniteLights || hasInfiniteLights;
const bool hasTextures =
    hasColorTextures || hasRoughnessTextures || hasSpecularTextures || hasNormalMaps || hasAlpha;

#endif
