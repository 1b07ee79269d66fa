// The packed scene: what the host uploads and the kernels read.
#ifndef CALOTYPE_SHARED_SCENE_STRUCTS_H
#define CALOTYPE_SHARED_SCENE_STRUCTS_H

#include "shared/specialization.h"
#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

/// "None" in every index of the structs.
CALOTYPE_CONSTANT uint kNone = 0xFFFFFFFFu;

/// A primitive's name is its index among the triangles or, with this bit, among the quadrics.
CALOTYPE_CONSTANT uint kQuadricBit = 0x80000000u;

/// In a primitive's `material`: light may pass through it.
CALOTYPE_CONSTANT uint kTransparentBit = 0x80000000u;

// Quadric::kind.
CALOTYPE_CONSTANT uint kSphere = 0;
CALOTYPE_CONSTANT uint kCylinder = 1;
CALOTYPE_CONSTANT uint kCone = 2;
CALOTYPE_CONSTANT uint kDisk = 3;

// Material::lobes: the lobes of the material.
#define LOBE(id, member, people)                                                                   \
    CALOTYPE_CONSTANT uint kLobe##id = 1u << (kFeature##id - kFeatureDiffuse);
#include "shared/feature_table.h"
// Material::lobes: flags for the material's numbers, above the bits of the lobes.
CALOTYPE_CONSTANT uint kColorIsF0 = 0x10000u;      ///< GGX of a metal; else F0 is `specular`
CALOTYPE_CONSTANT uint kColorIsTint = 0x20000u;    ///< of light that crosses a clear surface
CALOTYPE_CONSTANT uint kSmithMasking = 0x40000u;   ///< GGX
CALOTYPE_CONSTANT uint kNormalizedLobe = 0x80000u; ///< Blinn-Phong

// Texture::flags.
CALOTYPE_CONSTANT uint kTextureIsChecker = 1u;
CALOTYPE_CONSTANT uint kTextureHoldsFloats = 2u; ///< one texel a row; else four of 8-bit RGBA
CALOTYPE_CONSTANT uint kTextureIsEncoded = 4u;   ///< colours are sRGB-encoded
CALOTYPE_CONSTANT uint kTextureIsNearest = 8u;
CALOTYPE_CONSTANT uint kTextureClamps = 16u;
CALOTYPE_CONSTANT uint kTextureMirrors = 32u;
CALOTYPE_CONSTANT uint kTextureIsCutOut = 64u; ///< filters weigh the colour of a texel by its alpha

// Light::kind, in the order of the features: kLightTriangle, kLightSphere...
#define LIGHT(id, sort, people)                                                                    \
    CALOTYPE_CONSTANT uint kLight##id = kFeature##id##Lights - kFeatureTriangleLights;
#include "shared/feature_table.h"

// The sorts of kinds of lights.
CALOTYPE_CONSTANT uint kSortArea = 0u;
CALOTYPE_CONSTANT uint kSortUniformQuadric = 1u;
CALOTYPE_CONSTANT uint kSortInfinite = 2u; ///< found by rays that hit no surface

// The sort of each kind, in two bits.
#define BEGIN_FEATURES CALOTYPE_CONSTANT uint kSortsOfLights = 0u
#define LIGHT(id, sort, people) | (kSort##sort << 2u * kLight##id)
#define END_FEATURES ;
#include "shared/feature_table.h"

CALOTYPE_FUNCTION uint sortOfLight(uint kind) { return (kSortsOfLights >> 2u * kind) & 3u; }

// Light::flags.
CALOTYPE_CONSTANT uint kLightEmitsFromBack = 1u;
CALOTYPE_CONSTANT uint kLightHiddenFromCamera = 2u;
CALOTYPE_CONSTANT uint kLightBySolidAngle = 4u; // of a triangle, where single precision allows it

// In LightNode::child0 and child1.
CALOTYPE_CONSTANT uint kChildIsLight = 0x80000000u;
CALOTYPE_CONSTANT uint kChildIsTwoSided = 0x40000000u; ///< normals may be opposite to the cone

#include "shared/declare_structs.h"
#include "shared/scene_struct_table.h"

CALOTYPE_END_SHARED

#endif
