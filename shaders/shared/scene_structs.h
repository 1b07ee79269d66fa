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

/// In a primitive's `material`: light may pass through it.
CALOTYPE_CONSTANT uint kTransparentBit = 0x80000000u;

/// Up to eight children, whose boxes lie on a grid over the node's own: cell boundaries are at
/// origin + k * size, k from 0 to 255, size a power of two. Triangles of leaves follow each other
/// from `firstTriangle` on and quadrics from `firstQuadric` on, each in the order of the children.
/// Of each child and side there is a byte, the first child's lowest.
struct BvhNode {
    vec3 origin;
    uint nodesAndExponents; ///< bytes: exponents of size.xyz as a float's, and a bit for each child
                            ///< that is a node
    uint childBase; ///< the child in slot i, if it is a node, lies at childBase + i; 24 bits
    uint firstTriangle;
    uint firstQuadric;
    uint primitives; ///< three bits a child, as many set as it has primitives; in the highest byte,
                     ///< a bit for each child whose primitives are quadrics
    uvec2 lowerX;
    uvec2 upperX;
    uvec2 lowerY;
    uvec2 upperY;
    uvec2 lowerZ;
    uvec2 upperZ;
};

/// The corners are bit-identical where triangles share them: watertightness rests on it. One cache
/// line of most processors, whose first three rows are what a ray needs.
struct Triangle {
    vec3 v0;
    float normalX; ///< of the front's unit normal, each component to the nearest float
    vec3 v1;
    float normalY;
    vec3 v2;
    float normalZ;
    uint material; ///< index, with kTransparentBit
    uint light;    ///< index of its light, or kNone
    uint id;       ///< number of the primitive in the order of the scene file
    uint pad0;
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

/// Texture coordinates at the corners of the triangle of the same index.
struct TriangleUvs {
    vec2 uv0;
    vec2 uv1;
    vec2 uv2;
    uint pad0;
    uint pad1;
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
    float slope;   ///< of a cone: radius / |y|
    uint material; ///< index, with kTransparentBit
    uint light;
    uint id;
    uint pad0;
    vec3 centerRest; ///< of a sphere: what rounding took from its centre
    uint pad1;
};

// The lobes that a material is made of. At most one of GGX and Blinn-Phong; a dielectric has none.
CALOTYPE_CONSTANT uint kLobeDiffuse = 1u;
CALOTYPE_CONSTANT uint kLobeGgx = 2u;
CALOTYPE_CONSTANT uint kLobeBlinnPhong = 4u;
CALOTYPE_CONSTANT uint kLobeDielectric = 8u;
// How its numbers are read.
CALOTYPE_CONSTANT uint kColorIsF0 = 16u;      ///< GGX of a metal, else F0 is `specular`
CALOTYPE_CONSTANT uint kSmithMasking = 32u;   ///< GGX
CALOTYPE_CONSTANT uint kNormalizedLobe = 64u; ///< Blinn-Phong

/// A texture, where there is one, multiplies the number beside it.
struct Material {
    vec3 color; ///< reflectance, F0 or tint
    uint colorTexture;
    float roughness;
    uint roughnessTexture;
    float specular; ///< F0 of a nonmetal, ks of Blinn-Phong
    uint specularTexture;
    uint lobes;
    uint normalMap;
    uint alphaTexture;
    float opacity;
    float kd;       ///< Blinn-Phong: weight of the diffuse lobe
    float exponent; ///< Blinn-Phong
    float eta;      ///< dielectric: index of refraction inside over outside
    uint pad0;
};

// A texture's `flags`.
CALOTYPE_CONSTANT uint kTextureIsChecker = 1u;
CALOTYPE_CONSTANT uint kTextureHoldsFloats = 2u; ///< one texel a row, else four of 8-bit RGBA
CALOTYPE_CONSTANT uint kTextureIsEncoded = 4u;   ///< colours are sRGB-encoded
CALOTYPE_CONSTANT uint kTextureIsNearest = 8u;
CALOTYPE_CONSTANT uint kTextureClamps = 16u;
CALOTYPE_CONSTANT uint kTextureMirrors = 32u;

/// An image, or a checker of two colours.
struct Texture {
    vec2 scale; ///< read at uv * scale + offset
    vec2 offset;
    uint firstRow; ///< of its texels
    uint width;
    uint height;
    uint flags;
    vec3 color0;
    uint pad0;
    vec3 color1;
    uint pad1;
};

// A light's `kind`. Those of quadrics are in the order of Quadric::kind.
CALOTYPE_CONSTANT uint kLightTriangle = 0;
CALOTYPE_CONSTANT uint kLightSphere = 1;
CALOTYPE_CONSTANT uint kLightCylinder = 2;
CALOTYPE_CONSTANT uint kLightCone = 3;
CALOTYPE_CONSTANT uint kLightDisk = 4;
CALOTYPE_CONSTANT uint kLightBackground = 5; ///< all directions, infinitely far away

// A light's `flags`.
CALOTYPE_CONSTANT uint kLightEmitsFromBack = 1u;
CALOTYPE_CONSTANT uint kLightHiddenFromCamera = 2u;

/// An emitting primitive or the background, and its column of the alias table by which lights are
/// chosen.
struct Light {
    vec3 radiance;
    uint primitive;             ///< kNone of a light that is infinitely far away
    float area;                 ///< m^2; 0 of a light that is infinitely far away
    float selectionProbability; ///< probability with which this light is chosen
    uint firstNumber;  ///< of the random numbers that fall into the column, in units of 2^-24
    uint ownNumbers;   ///< those from there on that choose this light
    uint aliasNumbers; ///< those after them, which choose the light `alias`
    uint alias;
    uint flags;
    uint kind;
};

/// Perspective: `right` and `up` reach from the centre of the image plane, one unit along
/// `forward`, to its edges. Orthographic: they reach from `position` to the edges of the view.
struct Camera {
    vec3 position;
    float focusDistance; ///< along forward, metres
    vec3 right;
    uint isOrthographic;
    vec3 up;
    uint filterIsBox; ///< of the film; else it is the table's
    vec3 forward;
    uint pad0;
    vec3 lensRight; ///< the lens's radius along right and up; zero for a pinhole
    uint pad1;
    vec3 lensUp;
    uint pad2;
};

CALOTYPE_END_SHARED

#ifdef __cplusplus
namespace calotype::shared {
static_assert(sizeof(BvhNode) == 80);
static_assert(sizeof(Triangle) == 64);
static_assert(sizeof(TriangleNormals) == 48);
static_assert(sizeof(TriangleUvs) == 32);
static_assert(sizeof(Quadric) == 96);
static_assert(sizeof(Material) == 64);
static_assert(sizeof(Texture) == 64);
static_assert(sizeof(Light) == 48);
static_assert(sizeof(Camera) == 96);
} // namespace calotype::shared
#endif

#endif
