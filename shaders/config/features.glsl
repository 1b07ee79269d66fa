// What the scene at hand requires. All default to true: specialising only ever removes code.
#ifndef CALOTYPE_CONFIG_FEATURES_GLSL
#define CALOTYPE_CONFIG_FEATURES_GLSL

#include "shared/bindings.h"

layout(constant_id = kFeatureTriangles) const bool hasTriangles = true;
layout(constant_id = kFeatureSmoothNormals) const bool hasSmoothNormals = true;
layout(constant_id = kFeatureSpheres) const bool hasSpheres = true;
layout(constant_id = kFeatureCylinders) const bool hasCylinders = true;
layout(constant_id = kFeatureCones) const bool hasCones = true;
layout(constant_id = kFeatureDisks) const bool hasDisks = true;
layout(constant_id = kFeatureManyQuadrics) const bool hasManyQuadrics = true;
layout(constant_id = kFeatureTriangleLights) const bool hasTriangleLights = true;
layout(constant_id = kFeatureSphereLights) const bool hasSphereLights = true;
layout(constant_id = kFeatureCylinderLights) const bool hasCylinderLights = true;
layout(constant_id = kFeatureConeLights) const bool hasConeLights = true;
layout(constant_id = kFeatureDiskLights) const bool hasDiskLights = true;
layout(constant_id = kFeatureHiddenLights) const bool hasHiddenLights = true;
layout(constant_id = kFeatureLightAlpha) const bool hasLightAlpha = true;
layout(constant_id = kFeatureBackground) const bool hasBackground = true;
layout(constant_id = kFeatureDiffuse) const bool hasDiffuse = true;
layout(constant_id = kFeatureGgx) const bool hasGgx = true;
layout(constant_id = kFeatureMirrors) const bool hasMirrors = true;
layout(constant_id = kFeatureBlinnPhong) const bool hasBlinnPhong = true;
layout(constant_id = kFeatureDielectrics) const bool hasDielectrics = true;
layout(constant_id = kFeatureColorTextures) const bool hasColorTextures = true;
layout(constant_id = kFeatureRoughnessTextures) const bool hasRoughnessTextures = true;
layout(constant_id = kFeatureSpecularTextures) const bool hasSpecularTextures = true;
layout(constant_id = kFeatureNormalMaps) const bool hasNormalMaps = true;
layout(constant_id = kFeatureAlpha) const bool hasAlpha = true;
layout(constant_id = kFeatureByteTexels) const bool hasByteTexels = true;
layout(constant_id = kFeatureFloatTexels) const bool hasFloatTexels = true;
layout(constant_id = kFeatureCheckers) const bool hasCheckers = true;
layout(constant_id = kFeatureFilter) const bool hasFilter = true;
layout(constant_id = kFeatureLens) const bool hasLens = true;
layout(constant_id = kFeatureOrthographic) const bool hasOrthographic = true;

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
