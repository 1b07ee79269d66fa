// The packed scene: what the host uploads and the kernels read. Every struct is rows of 16 bytes,
// so that C++, std140, std430 and scalar layouts agree. Lengths are metres, in a frame whose origin
// the host moved near the camera.
#ifndef CALOTYPE_SHARED_SCENE_STRUCTS_H
#define CALOTYPE_SHARED_SCENE_STRUCTS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

/// "None" in every index below.
CALOTYPE_CONSTANT uint kNone = 0xFFFFFFFFu;

/// A primitive is named by its index among the triangles, or, with this bit, among the quadrics.
CALOTYPE_CONSTANT uint kQuadricBit = 0x80000000u;

/// Inner node: children at `first` and `first + 1`, `count` is 0. Leaf: `count` primitives named
/// `first`, `first + 1`, ..., all triangles or all quadrics.
struct BvhNode {
    vec3 lower;
    uint first;
    vec3 upper;
    uint count;
};

/// The corners are bit-identical where triangles share them: watertightness rests on it.
struct Triangle {
    vec3 v0;
    uint material;
    vec3 v1;
    uint light; ///< index of its light, or kNone
    vec3 v2;
    uint id; ///< number of the primitive in the order of the scene file
};

/// Shading normals at the corners of the triangle of the same index; zero where it has none.
struct TriangleNormals {
    vec3 n0;
    uint pad0;
    vec3 n1;
    uint pad1;
    vec3 n2;
    uint pad2;
};

CALOTYPE_CONSTANT uint kSphere = 0;
CALOTYPE_CONSTANT uint kCylinder = 1;
CALOTYPE_CONSTANT uint kCone = 2;
CALOTYPE_CONSTANT uint kDisk = 3;

/// Sphere, cylinder, cone or disk in a local frame with axis y. `extent` is the height of a
/// cylinder or the signed height of a cone; `radius` is the cone's at its base.
struct Quadric {
    vec3 center; ///< of a sphere, cylinder or disk; a cone's apex
    float radius;
    vec3 axisX; ///< the frame's axes in the world: orthonormal
    float extent;
    vec3 axisY;
    uint kind;
    vec3 axisZ;
    float slope; ///< of a cone: radius / |y|
    uint material;
    uint light;
    uint id;
    uint pad0;
};

/// Lambertian reflectance.
struct Material {
    vec3 color;
    uint pad0;
};

CALOTYPE_CONSTANT uint kLightEmitsFromBack = 1u;
CALOTYPE_CONSTANT uint kLightHiddenFromCamera = 2u;

/// An emitting primitive, and its column of the alias table by which lights are chosen.
struct Light {
    vec3 radiance;
    uint primitive;
    float area;            ///< m^2
    float selectionChance; ///< probability with which this light is chosen
    float aliasThreshold;  ///< keep this column when the remainder is below, else take `alias`
    uint alias;
    uint flags;
    uint pad0;
    uint pad1;
    uint pad2;
};

/// Pinhole camera at `position`; `right` and `up` reach from the centre of the image plane, one
/// unit along `forward`, to its edges.
struct Camera {
    vec3 position;
    uint pad0;
    vec3 right;
    uint pad1;
    vec3 up;
    uint pad2;
    vec3 forward;
    uint pad3;
};

CALOTYPE_END_SHARED

#ifdef __cplusplus
namespace calotype::gpu {
static_assert(sizeof(BvhNode) == 32);
static_assert(sizeof(Triangle) == 48);
static_assert(sizeof(TriangleNormals) == 48);
static_assert(sizeof(Quadric) == 80);
static_assert(sizeof(Material) == 16);
static_assert(sizeof(Light) == 48);
static_assert(sizeof(Camera) == 64);
} // namespace calotype::gpu
#endif

#endif
