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
const bool hasOtherQuadricLights = hasCylinderLights || hasConeLights || hasDiskLights;
const bool hasQuadricLights = hasSphereLights || hasOtherQuadricLights;
const bool hasAreaLights = hasTriangleLights || hasQuadricLights;
const bool hasLights = hasAreaLights || hasBackground;
const bool hasTextures =
    hasColorTextures || hasRoughnessTextures || hasSpecularTextures || hasNormalMaps || hasAlpha;

#endif
