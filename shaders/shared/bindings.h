// Descriptor bindings of set 0 and identifiers of specialization constants.
#ifndef CALOTYPE_SHARED_BINDINGS_H
#define CALOTYPE_SHARED_BINDINGS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

// The packed scene, as texel buffers of 16-byte rows (the fastest fetch on llvmpipe, measured).
CALOTYPE_CONSTANT uint kBindingNodes = 0;
CALOTYPE_CONSTANT uint kBindingTriangles = 1;
CALOTYPE_CONSTANT uint kBindingTriangleNormals = 2;
CALOTYPE_CONSTANT uint kBindingTriangleUvs = 3;
CALOTYPE_CONSTANT uint kBindingQuadrics = 4;
CALOTYPE_CONSTANT uint kBindingMaterials = 5;
CALOTYPE_CONSTANT uint kBindingTextures = 6;
CALOTYPE_CONSTANT uint kBindingTexels = 7;
CALOTYPE_CONSTANT uint kBindingLights = 8;
CALOTYPE_CONSTANT uint kBindingFilter = 9;
CALOTYPE_CONSTANT uint kSceneBindingCount = 10;

CALOTYPE_CONSTANT uint kBindingCamera = 10;   ///< uniform buffer
CALOTYPE_CONSTANT uint kBindingBlock = 11;    ///< storage image
CALOTYPE_CONSTANT uint kBindingCounters = 12; ///< storage buffer
/// Storage buffer of one FirstHitRecord, in words, per pixel of the dispatch's tiles.
CALOTYPE_CONSTANT uint kBindingFirstHits = 13;
/// Storage buffer of one ParkedPath per task of every lane of every workgroup of a dispatch.
CALOTYPE_CONSTANT uint kBindingParkedPaths = 14;
CALOTYPE_CONSTANT uint kBindingRays = 15;       ///< storage buffer of ListedRay
CALOTYPE_CONSTANT uint kBindingListedHits = 16; ///< storage buffer of ListedHit
/// Storage buffer of the numbers of the tiles to render, row by row, in the order to take them in.
CALOTYPE_CONSTANT uint kBindingTiles = 17;

// Scene features: what the kernel is specialised for. All default to true.
CALOTYPE_CONSTANT uint kFeatureTriangles = 0;
CALOTYPE_CONSTANT uint kFeatureSmoothNormals = 1;
CALOTYPE_CONSTANT uint kFeatureSpheres = 2;
CALOTYPE_CONSTANT uint kFeatureCylinders = 3;
CALOTYPE_CONSTANT uint kFeatureCones = 4;
CALOTYPE_CONSTANT uint kFeatureDisks = 5;
CALOTYPE_CONSTANT uint kFeatureManyQuadrics = 6; ///< too many for rays to wait with them
CALOTYPE_CONSTANT uint kFeatureTriangleLights = 7;
CALOTYPE_CONSTANT uint kFeatureSphereLights = 8;
CALOTYPE_CONSTANT uint kFeatureCylinderLights = 9;
CALOTYPE_CONSTANT uint kFeatureConeLights = 10;
CALOTYPE_CONSTANT uint kFeatureDiskLights = 11;
CALOTYPE_CONSTANT uint kFeatureHiddenLights = 12;
CALOTYPE_CONSTANT uint kFeatureLightAlpha = 13; ///< alpha of what shines
CALOTYPE_CONSTANT uint kFeatureBackground = 14;
CALOTYPE_CONSTANT uint kFeatureDiffuse = 15;
CALOTYPE_CONSTANT uint kFeatureGgx = 16;
CALOTYPE_CONSTANT uint kFeatureMirrors = 17; ///< GGX of (almost) no roughness
CALOTYPE_CONSTANT uint kFeatureBlinnPhong = 18;
CALOTYPE_CONSTANT uint kFeatureDielectrics = 19;
CALOTYPE_CONSTANT uint kFeatureColorTextures = 20;
CALOTYPE_CONSTANT uint kFeatureRoughnessTextures = 21;
CALOTYPE_CONSTANT uint kFeatureSpecularTextures = 22;
CALOTYPE_CONSTANT uint kFeatureNormalMaps = 23;
CALOTYPE_CONSTANT uint kFeatureAlpha = 24;
CALOTYPE_CONSTANT uint kFeatureByteTexels = 25;
CALOTYPE_CONSTANT uint kFeatureFloatTexels = 26;
CALOTYPE_CONSTANT uint kFeatureCheckers = 27;
CALOTYPE_CONSTANT uint kFeatureFilter = 28; ///< any but the box
CALOTYPE_CONSTANT uint kFeatureLens = 29;
CALOTYPE_CONSTANT uint kFeatureOrthographic = 30;
CALOTYPE_CONSTANT uint kFeatureCount = 31;

// Specialization constants that suit the kernel to a device.
CALOTYPE_CONSTANT uint kConstantSubgroupSize = 31; ///< of a workgroup, which is one subgroup
CALOTYPE_CONSTANT uint kConstantNodeEighths = 32;
CALOTYPE_CONSTANT uint kConstantPrimitiveEighths = 33;
CALOTYPE_CONSTANT uint kConstantRayEighths = 34;
CALOTYPE_CONSTANT uint kConstantEventEighths = 35;
CALOTYPE_CONSTANT uint kConstantSharesStack = 36;

/// Whether random numbers are Sobol's.
CALOTYPE_CONSTANT uint kConstantSobol = 37;

// How light is looked for along a path.
CALOTYPE_CONSTANT uint kConstantMis = 38;
CALOTYPE_CONSTANT uint kConstantRoulette = 39;
CALOTYPE_CONSTANT uint kConstantClampsIndirect = 40;

CALOTYPE_CONSTANT uint kConstantCount = 41;

CALOTYPE_END_SHARED

#endif
