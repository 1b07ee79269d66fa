// What the test kernels take and give back, in rows of 16 bytes as in shaders/shared.
#ifndef CALOTYPE_TEST_STRUCTS_H
#define CALOTYPE_TEST_STRUCTS_H

#include "shared/bindings.h"
#include "shared/scene_structs.h"
#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

/// First bindings of the arrays in kernels that include buffers/packed_scene.glsl.
CALOTYPE_CONSTANT uint kBindingTestInputs = kBindingCount;
CALOTYPE_CONSTANT uint kBindingTestOutputs = kBindingCount + 1;

struct TestRay {
    vec3 origin;
    uint primitive; ///< the only one to meet (hits), or never to meet (traversals)
    vec3 direction;
    float tMax;
    uint anyHit; ///< 1: end at the first hit found
    uint pad0;
    uint pad1;
    uint pad2;
};

struct TestHit {
    vec3 position;
    float t;
    vec3 ng;
    float error;
    vec3 ns;
    uint id;
    float barycentric1;
    float barycentric2;
    uint primitive;
    uint iterations;
};

struct TestOffset {
    vec3 position;
    float error;
    vec3 ng;
    float pad0;
};

struct TestLightQuery {
    vec3 shadingPoint;
    uint light;
    vec4 u; ///< x, y: on the light; z, w: choice of a light, and between two such numbers
    uint lightCount;
    uint pad0;
    uint pad1;
    uint pad2;
};

struct TestChoiceQuery {
    vec3 shadingPoint;
    uint light; ///< whose probability is asked for as well
    vec3 normal;
    uint lightCount;
    vec2 u; ///< choice of a light, and between two such numbers
    uint infiniteLight;
    uint lightTreeDepth;
};

struct TestLightChoice {
    uint light;
    float u;
    float probability;
    float probabilityForMis;
    float probabilityOfGiven; ///< of the light of the query
    uint pad0;
    uint pad1;
    uint pad2;
};

struct TestLightSample {
    vec3 position;
    float error;
    vec3 normal;
    float pdf;
    float pdfOfHit; ///< finiteLightPdf at the same point
    uint chosen;    ///< light picked by u.zw
    uint pad0;
    uint pad1;
    vec4 emitted; ///< towards the shading point
};

struct TestScattering {
    vec3 ng;
    float u1;
    vec3 ns;
    float u2;
    vec3 wo;
    float u3;
    vec3 wi; ///< for `given`
    float pad0;
    Material material; ///< without textures
};

struct TestScattered {
    vec3 wi;
    float pdf;
    vec3 weight;
    float pdfAgain; ///< evaluateBsdf at wi
    vec3 value;     ///< evaluateBsdf at wi
    uint crosses;
    vec3 given; ///< evaluateBsdf at the event's wi
    float givenPdf;
    vec3 ns;                  ///< as bent to the viewer
    float diffuseProbability; ///< with which the diffuse lobe is sampled
};

/// One lobe alone, sampled, and evaluated at the direction that it drew and at the event's wi.
struct TestLobe {
    vec3 wi;
    float pdf;  ///< lobePdf at wi
    vec3 value; ///< evaluateLobe at wi
    float albedo;
    vec3 specularWeight;
    uint isSpecularSample;
    vec3 given; ///< evaluateLobe at the event's wi
    float givenPdf;
    uint isSpecular;
    float eta;
    uint pad0;
    uint pad1;
};

/// One sample of one pixel.
struct TestPath {
    Camera camera;
    uvec2 pixel;
    uvec2 imageSize;
    uint sampleIndex;
    uint seed;
    uint maxBounces;
    uint lightCount;
    uint infiniteLight;
    uint lightTreeDepth;
    uint pad0;
    uint pad1;
};

struct TestTextureRead {
    vec2 uv;
    uint index;
    uint decode;
};

struct TestCoordinates {
    vec3 position;
    float u;
    vec3 dpdu;
    float v;
    vec3 dpdv;
    float t;
};

struct TestNormalMap {
    vec3 texel;
    float pad0;
    vec3 n;
    float pad1;
    vec3 dpdu;
    float pad2;
    vec3 dpdv;
    float pad3;
    vec3 ng;
    float pad4;
    vec3 wo; ///< for consistentNormal of n
    float pad5;
};

struct TestNormals {
    vec3 mapped;
    float pad0;
    vec3 consistent;
    float pad1;
};

struct TestFilmQuery {
    Camera camera;
    vec2 position; ///< on the film, pixels
    vec2 u;        ///< on the lens
    uvec2 imageSize;
    uint pad0;
    uint pad1;
};

struct TestCameraRay {
    vec3 origin;
    float tMax;
    vec3 direction;
    float pad0;
};

struct TestSmoothPoint {
    Triangle triangle;
    TriangleNormals normals;
    vec3 position;
    float side;
    vec2 barycentrics;
    float pad0;
    float pad1;
};

CALOTYPE_END_SHARED

#endif
