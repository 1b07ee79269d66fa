// Textures are filtered in software: hardware filters with weights of 8 bits, and not every driver
// supports filtering for images of any number and size.
//
// v = 0 is the bottom, row 0 of an image is its top; texel centres are at (i + 1/2) / n. Colours
// are decoded before they are filtered, and weighted by their alpha where it cuts holes.
#ifndef CALOTYPE_SCENE_TEXTURE_GLSL
#define CALOTYPE_SCENE_TEXTURE_GLSL

#include "buffers/packed_scene.glsl"
#include "config/features.glsl"
#include "core/srgb.glsl"

/// Texture coordinates wrapped into [0, 1], exactly but for those between -2 and 0. `precise` keeps
/// compilers from subtracting the constant 1 from the coordinate first, which may round.
vec2 wrapCoordinates(vec2 uv, uint flags) {
    vec2 repeated = uv - floor(uv);
    precise vec2 inPeriod = uv - 2.0 * floor(0.5 * uv);
    vec2 mirrored = 1.0 - abs(inPeriod - 1.0);
    vec2 clamped = clamp(uv, 0.0, 1.0);
    return (flags & kTextureMirrors) != 0u  ? mirrored
           : (flags & kTextureClamps) != 0u ? clamped
                                            : repeated;
}

/// Wraps a column or row next to the edge of an image: to the other edge if the image repeats. The
/// result is always inside the image, also for a coordinate that was rounded to 1 or is NaN.
int wrapTexel(int i, int count, uint flags) {
    bool repeats = (flags & (kTextureClamps | kTextureMirrors)) == 0u;
    int wrapped = i < 0 ? i + count : i >= count ? i - count : i;
    return clamp(repeats ? wrapped : i, 0, count - 1);
}

/// Four numbers in [0, 1] from 8 bits each, lowest first. 255 becomes 1 exactly.
vec4 unpackBytes(uint word) {
    uvec4 bytes = uvec4(word, word >> 8u, word >> 16u, word >> 24u) & 255u;
    return vec4(bytes) * (1.0 / 255.0);
}

/// The texel in column i and row j, counted from the bottom.
vec4 loadTexel(Texture image, int i, int j, bool decode) {
    uint column = uint(wrapTexel(i, int(image.width), image.flags));
    uint row = image.height - 1u - uint(wrapTexel(j, int(image.height), image.flags));
    uint index = row * image.width + column;
    vec4 texel = vec4(0.0);
    if (hasByteTexels && (image.flags & kTextureHoldsFloats) == 0u) {
        uvec4 words = loadTexelRow(image.firstRow + (index >> 2u));
        texel = unpackBytes(words[index & 3u]);
    }
    if (hasFloatTexels && (image.flags & kTextureHoldsFloats) != 0u)
        texel = uintBitsToFloat(loadTexelRow(image.firstRow + index));
    bool encoded = decode && (image.flags & kTextureIsEncoded) != 0u;
    return vec4(encoded ? linearFromSrgb(texel.rgb) : texel.rgb, texel.a);
}

/// `filtered` with the mean colour of four texels, weighted by their alpha too: the colour of a
/// transparent texel has no meaning. Where all four are transparent, the colour stays.
vec4 weighByAlpha(vec4 filtered, vec4 texels[4], vec2 f) {
    vec4 alphas = vec4(texels[0].a, texels[1].a, texels[2].a, texels[3].a);
    vec4 shares =
        alphas * vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
    float total = shares.x + shares.y + shares.z + shares.w;
    if (!(total > 0.0))
        return filtered;
    vec3 sum = shares.x * texels[0].rgb + shares.y * texels[1].rgb + shares.z * texels[2].rgb +
               shares.w * texels[3].rgb;
    return vec4(sum / total, filtered.a);
}

vec4 sampleImage(Texture image, vec2 uv, bool decode) {
    bool nearest = (image.flags & kTextureIsNearest) != 0u;
    vec2 size = vec2(image.width, image.height);
    vec2 position = wrapCoordinates(uv, image.flags) * size - (nearest ? 0.0 : 0.5);
    vec2 corner = floor(position);
    vec2 f = nearest ? vec2(0.0) : position - corner;
    int i = int(corner.x);
    int j = int(corner.y);
    vec4 texels[4] =
        vec4[4](loadTexel(image, i, j, decode), loadTexel(image, i + 1, j, decode),
                loadTexel(image, i, j + 1, decode), loadTexel(image, i + 1, j + 1, decode));
    vec4 lower = (1.0 - f.x) * texels[0] + f.x * texels[1];
    vec4 upper = (1.0 - f.x) * texels[2] + f.x * texels[3];
    vec4 filtered = (1.0 - f.y) * lower + f.y * upper;
    if (hasCutOutColors && (image.flags & kTextureIsCutOut) != 0u)
        return weighByAlpha(filtered, texels, f);
    return filtered;
}

/// RGB and alpha at texture coordinates. `decode` makes sRGB-encoded colours linear.
vec4 sampleTexture(uint index, vec2 uv, bool decode) {
    Texture source = loadTexture(index);
    vec2 position = uv * source.scale + source.offset;
    if (hasCheckers && (source.flags & kTextureIsChecker) != 0u) {
        vec2 field = floor(position);
        float halfSum = 0.5 * (field.x + field.y);
        return vec4(halfSum == floor(halfSum) ? source.color0 : source.color1, 1.0);
    }
    return sampleImage(source, position, decode);
}

#endif
