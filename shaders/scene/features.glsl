// What the scene at hand requires. All default to true: specialising only ever removes code.
#ifndef CALOTYPE_SCENE_FEATURES_GLSL
#define CALOTYPE_SCENE_FEATURES_GLSL

#include "shared/bindings.h"

layout(constant_id = kFeatureTriangles) const bool hasTriangles = true;
layout(constant_id = kFeatureSmoothNormals) const bool hasSmoothNormals = true;
layout(constant_id = kFeatureSpheres) const bool hasSpheres = true;
layout(constant_id = kFeatureCylinders) const bool hasCylinders = true;
layout(constant_id = kFeatureCones) const bool hasCones = true;
layout(constant_id = kFeatureDisks) const bool hasDisks = true;
layout(constant_id = kFeatureTriangleLights) const bool hasTriangleLights = true;
layout(constant_id = kFeatureSphereLights) const bool hasSphereLights = true;
layout(constant_id = kFeatureCylinderLights) const bool hasCylinderLights = true;
layout(constant_id = kFeatureConeLights) const bool hasConeLights = true;
layout(constant_id = kFeatureDiskLights) const bool hasDiskLights = true;
layout(constant_id = kFeatureHiddenLights) const bool hasHiddenLights = true;

const bool hasQuadrics = hasSpheres || hasCylinders || hasCones || hasDisks;
const bool hasLights =
    hasTriangleLights || hasSphereLights || hasCylinderLights || hasConeLights || hasDiskLights;

#endif
