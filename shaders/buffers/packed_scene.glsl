// The packed scene's texel buffers, and reading a struct from its rows. The order of the rows is
// that of the fields in shared/scene_structs.h; tests/gpu echoes every field back.
#ifndef CALOTYPE_BUFFERS_PACKED_SCENE_GLSL
#define CALOTYPE_BUFFERS_PACKED_SCENE_GLSL

#include "shared/bindings.h"
#include "shared/scene_structs.h"

layout(set = 0, binding = kBindingNodes) uniform usamplerBuffer nodeRows;
layout(set = 0, binding = kBindingTriangles) uniform usamplerBuffer triangleRows;
layout(set = 0, binding = kBindingTriangleNormals) uniform usamplerBuffer triangleNormalRows;
layout(set = 0, binding = kBindingTriangleUvs) uniform usamplerBuffer triangleUvRows;
layout(set = 0, binding = kBindingQuadrics) uniform usamplerBuffer quadricRows;
layout(set = 0, binding = kBindingMaterials) uniform usamplerBuffer materialRows;
layout(set = 0, binding = kBindingTextures) uniform usamplerBuffer textureRows;
layout(set = 0, binding = kBindingTexels) uniform usamplerBuffer texelRows;
layout(set = 0, binding = kBindingLights) uniform usamplerBuffer lightRows;
layout(set = 0, binding = kBindingFilter) uniform usamplerBuffer filterRows;

vec3 floats(uvec4 row) { return uintBitsToFloat(row.xyz); }

BvhNode loadNode(uint index) {
    uvec4 row0 = texelFetch(nodeRows, int(5u * index));
    uvec4 row1 = texelFetch(nodeRows, int(5u * index + 1u));
    uvec4 row2 = texelFetch(nodeRows, int(5u * index + 2u));
    uvec4 row3 = texelFetch(nodeRows, int(5u * index + 3u));
    uvec4 row4 = texelFetch(nodeRows, int(5u * index + 4u));
    return BvhNode(floats(row0), row0.w, row1.x, row1.y, row1.z, row1.w, row2.xy, row2.zw, row3.xy,
                   row3.zw, row4.xy, row4.zw);
}

Triangle loadTriangle(uint index) {
    uvec4 row0 = texelFetch(triangleRows, int(4u * index));
    uvec4 row1 = texelFetch(triangleRows, int(4u * index + 1u));
    uvec4 row2 = texelFetch(triangleRows, int(4u * index + 2u));
    uvec4 row3 = texelFetch(triangleRows, int(4u * index + 3u));
    vec3 normal = uintBitsToFloat(uvec3(row0.w, row1.w, row2.w));
    return Triangle(floats(row0), normal.x, floats(row1), normal.y, floats(row2), normal.z, row3.x,
                    row3.y, row3.z, row3.w);
}

TriangleNormals loadTriangleNormals(uint index) {
    uvec4 row0 = texelFetch(triangleNormalRows, int(3u * index));
    uvec4 row1 = texelFetch(triangleNormalRows, int(3u * index + 1u));
    uvec4 row2 = texelFetch(triangleNormalRows, int(3u * index + 2u));
    return TriangleNormals(floats(row0), row0.w, floats(row1), row1.w, floats(row2), row2.w);
}

TriangleUvs loadTriangleUvs(uint index) {
    vec4 row0 = uintBitsToFloat(texelFetch(triangleUvRows, int(2u * index)));
    uvec4 row1 = texelFetch(triangleUvRows, int(2u * index + 1u));
    return TriangleUvs(row0.xy, row0.zw, uintBitsToFloat(row1.xy), row1.z, row1.w);
}

Quadric loadQuadric(uint index) {
    uvec4 row0 = texelFetch(quadricRows, int(6u * index));
    uvec4 row1 = texelFetch(quadricRows, int(6u * index + 1u));
    uvec4 row2 = texelFetch(quadricRows, int(6u * index + 2u));
    uvec4 row3 = texelFetch(quadricRows, int(6u * index + 3u));
    uvec4 row4 = texelFetch(quadricRows, int(6u * index + 4u));
    uvec4 row5 = texelFetch(quadricRows, int(6u * index + 5u));
    return Quadric(floats(row0), uintBitsToFloat(row0.w), floats(row1), uintBitsToFloat(row1.w),
                   floats(row2), row2.w, floats(row3), uintBitsToFloat(row3.w), row4.x, row4.y,
                   row4.z, row4.w, floats(row5), row5.w);
}

Material loadMaterial(uint index) {
    uvec4 row0 = texelFetch(materialRows, int(4u * index));
    uvec4 row1 = texelFetch(materialRows, int(4u * index + 1u));
    uvec4 row2 = texelFetch(materialRows, int(4u * index + 2u));
    uvec4 row3 = texelFetch(materialRows, int(4u * index + 3u));
    return Material(floats(row0), row0.w, uintBitsToFloat(row1.x), row1.y, uintBitsToFloat(row1.z),
                    row1.w, row2.x, row2.y, row2.z, uintBitsToFloat(row2.w),
                    uintBitsToFloat(row3.x), uintBitsToFloat(row3.y), uintBitsToFloat(row3.z),
                    row3.w);
}

Texture loadTexture(uint index) {
    vec4 row0 = uintBitsToFloat(texelFetch(textureRows, int(4u * index)));
    uvec4 row1 = texelFetch(textureRows, int(4u * index + 1u));
    uvec4 row2 = texelFetch(textureRows, int(4u * index + 2u));
    uvec4 row3 = texelFetch(textureRows, int(4u * index + 3u));
    return Texture(row0.xy, row0.zw, row1.x, row1.y, row1.z, row1.w, floats(row2), row2.w,
                   floats(row3), row3.w);
}

/// A row of the texels of all images: four texels of 8-bit RGBA, or one of four floats.
uvec4 loadTexelRow(uint row) { return texelFetch(texelRows, int(row)); }

Light loadLight(uint index) {
    uvec4 row0 = texelFetch(lightRows, int(3u * index));
    uvec4 row1 = texelFetch(lightRows, int(3u * index + 1u));
    uvec4 row2 = texelFetch(lightRows, int(3u * index + 2u));
    return Light(floats(row0), row0.w, uintBitsToFloat(row1.x), uintBitsToFloat(row1.y), row1.z,
                 row1.w, row2.x, row2.y, row2.z, row2.w);
}

/// Entry `step` of the table of the film filter's quantiles.
float loadFilterQuantile(uint step) {
    uvec4 row = texelFetch(filterRows, int(step >> 2u));
    return uintBitsToFloat(row[step & 3u]);
}

#endif
