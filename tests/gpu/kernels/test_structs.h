// What the test kernels take and give back, in rows of 16 bytes as in shaders/shared.
#ifndef CALOTYPE_TEST_STRUCTS_H
#define CALOTYPE_TEST_STRUCTS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

/// First bindings of the arrays in kernels that include scene/buffers.glsl.
CALOTYPE_CONSTANT uint kBindingTestInputs = 16;
CALOTYPE_CONSTANT uint kBindingTestOutputs = 17;

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
    vec3 reference;
    uint light;
    vec4 u; ///< x, y: on the light; z, w: choice of a light
    uint lightCount;
    uint pad0;
    uint pad1;
    uint pad2;
};

struct TestLightSample {
    vec3 position;
    float error;
    vec3 normal;
    float pdf;
    float pdfOfHit; ///< lightPdf at the same point
    uint chosen;    ///< light picked by u.zw
    uint pad0;
    uint pad1;
    vec4 emitted; ///< towards the reference
};

struct TestScattering {
    vec3 ng;
    float u1;
    vec3 ns;
    float u2;
    vec3 wo;
    float u3;
    vec3 wi; ///< for `given`
    uint lobes;
    vec3 color;
    float roughness;
    float specular;
    float kd;
    float exponent;
    float eta;
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
    vec3 ns; ///< as bent to the viewer
    float diffuseChance;
};

CALOTYPE_END_SHARED

#endif
