// Descriptor bindings of set 0 and identifiers of specialization constants.
#ifndef CALOTYPE_SHARED_BINDINGS_H
#define CALOTYPE_SHARED_BINDINGS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

// The packed scene, as texel buffers of 16-byte rows (the fastest fetch on llvmpipe, measured).
CALOTYPE_CONSTANT uint kBindingNodes = 0;
CALOTYPE_CONSTANT uint kBindingTriangles = 1;
CALOTYPE_CONSTANT uint kBindingTriangleNormals = 2;
CALOTYPE_CONSTANT uint kBindingQuadrics = 3;
CALOTYPE_CONSTANT uint kBindingMaterials = 4;
CALOTYPE_CONSTANT uint kBindingLights = 5;
CALOTYPE_CONSTANT uint kSceneBindingCount = 6;

CALOTYPE_CONSTANT uint kBindingCamera = 6;   ///< uniform buffer
CALOTYPE_CONSTANT uint kBindingBlock = 7;    ///< storage image
CALOTYPE_CONSTANT uint kBindingCounters = 8; ///< storage buffer

// Scene features: what the kernel is specialised for. All default to true.
CALOTYPE_CONSTANT uint kFeatureTriangles = 0;
CALOTYPE_CONSTANT uint kFeatureSmoothNormals = 1;
CALOTYPE_CONSTANT uint kFeatureSpheres = 2;
CALOTYPE_CONSTANT uint kFeatureCylinders = 3;
CALOTYPE_CONSTANT uint kFeatureCones = 4;
CALOTYPE_CONSTANT uint kFeatureDisks = 5;
CALOTYPE_CONSTANT uint kFeatureTriangleLights = 6;
CALOTYPE_CONSTANT uint kFeatureSphereLights = 7;
CALOTYPE_CONSTANT uint kFeatureCylinderLights = 8;
CALOTYPE_CONSTANT uint kFeatureConeLights = 9;
CALOTYPE_CONSTANT uint kFeatureDiskLights = 10;
CALOTYPE_CONSTANT uint kFeatureHiddenLights = 11;
CALOTYPE_CONSTANT uint kFeatureCount = 12;

CALOTYPE_END_SHARED

#endif
