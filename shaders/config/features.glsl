// The features that the scene needs. All default to true: specialization only removes code.
#ifndef CALOTYPE_CONFIG_FEATURES_GLSL
#define CALOTYPE_CONFIG_FEATURES_GLSL

#include "shared/specialization.h"

#define BEGIN_FEATURES
#define FEATURE(id, people) layout(constant_id = kFeature##id) const bool has##id = true;
#define END_FEATURES
#include "shared/feature_table.h"

const bool hasQuadrics = hasSpheres || hasCylinders || hasCones || hasDisks;
const bool hasFewQuadrics = hasTriangles && hasQuadrics && !hasManyQuadrics;
const bool hasShadingNormals = hasSmoothNormals || hasNormalMaps;
const bool hasQuadricLights =
    hasSphereLights || hasCylinderLights || hasConeLights || hasDiskLights;

/// Kinds of lights that there may be.
#define BEGIN_FEATURES const uint kFiniteKinds = 0u
#define LIGHT(id, isInfinite, people) +(has##id##Lights && !isInfinite ? 1u : 0u)
#define END_FEATURES ;
#include "shared/feature_table.h"
#define BEGIN_FEATURES const uint kInfiniteKinds = 0u
#define LIGHT(id, isInfinite, people) +(has##id##Lights && isInfinite ? 1u : 0u)
#define END_FEATURES ;
#include "shared/feature_table.h"
const bool hasFiniteLights = kFiniteKinds > 0u;
const bool hasInfiniteLights = kInfiniteKinds > 0u;
const bool hasLights = hasFiniteLights || hasInfiniteLights;
const bool hasTextures =
    hasColorTextures || hasRoughnessTextures || hasSpecularTextures || hasNormalMaps || hasAlpha;

#endif
