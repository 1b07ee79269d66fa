// The layers that a picture can have beside its colour.
#ifndef CALOTYPE_SHARED_LAYERS_H
#define CALOTYPE_SHARED_LAYERS_H

#include "shared/types.h"

#ifdef __cplusplus
#include <cmath>
#endif

// One row for each layer, in the order of --help. There are three kinds of rows, by the source of
// the values:
//
// FIRST_HIT(name, type, nothing, channels, help): from the first surface on the ray through the
// middle of the pixel. shaders/path/first_hit.glsl and host/reference set the field `name` of a
// FirstHit. `nothing` is its value in C++ if the pixel shows no surface.
// AVERAGED(name, type, channels, help): from rays through the film's filter and the lens, followed
//     through mirrors and clear surfaces: shaders/path/features.glsl and host/reference set the
//     field `name` of Features for one ray; the layer is the mean of many.
// REPLICAS(name, first, type, channels, help): from the spread of the film's replicas: the fields
// of
//     a PixelError from `first` on.
// MATTE(name, kind, typeName, help): the share of each pixel that shows each of the objects or
//     materials (MatteKind), by Cryptomatte's rules (image/cryptomatte.h); `typeName` is its name
//     in EXR files.
//
// `type` is float, uint, vec2 or vec3. `channels` are the names of its components in an EXR file,
// after the name of the layer and a dot.
#define CALOTYPE_LAYERS(FIRST_HIT, AVERAGED, REPLICAS, MATTE)                                      \
    FIRST_HIT(albedo, vec3, 0.0f, "R,G,B",                                                         \
              "reflectance, linear Rec. 709: F0 of a metal, 1 of a dielectric, else the color")    \
    FIRST_HIT(normal, vec3, 0.0f, "X,Y,Z",                                                         \
              "unit shading normal in the world, on the side of the viewer")                       \
    FIRST_HIT(depth, float, INFINITY, "Z", "distance along the axis of the camera, metres")        \
    FIRST_HIT(position, vec3, 0.0f, "X,Y,Z", "point in the world, metres")                         \
    FIRST_HIT(primitive, uint, 0xFFFFFFFFu, "ID", "number of the primitive, from 0")               \
    FIRST_HIT(uv, vec2, 0.0f, "U,V", "texture coordinates, 0 where a mesh has none")               \
    AVERAGED(meanAlbedo, vec3, "R,G,B",                                                            \
             "albedo of the first surface that scatters, as seen in mirrors and through glass")    \
    AVERAGED(meanNormal, vec3, "X,Y,Z",                                                            \
             "its shading normal in the world, on the side of the viewer; shorter at edges")       \
    AVERAGED(meanDepth, float, "Z", "distance of the first surface along the axis, metres")        \
    AVERAGED(alpha, float, "A", "share of the pixel that shows a surface")                         \
    REPLICAS(error, standardError, vec2, "SE,CI95",                                                \
             "standard error of the luminance, and half of its 95 % interval, W/(m^2 sr)")         \
    MATTE(cryptoObject, Objects, "CryptoObject", "mattes of objects, as Cryptomatte")              \
    MATTE(cryptoMaterial, Materials, "CryptoMaterial", "mattes of materials, as Cryptomatte")

/// Only the rows of one kind.
#define CALOTYPE_NO_FIRST_HIT_ROW(name, type, nothing, channels, help)
#define CALOTYPE_NO_AVERAGED_ROW(name, type, channels, help)
#define CALOTYPE_NO_REPLICAS_ROW(name, first, type, channels, help)
#define CALOTYPE_NO_MATTE_ROW(name, kind, typeName, help)
#define CALOTYPE_FIRST_HIT_LAYERS(ROW)                                                             \
    CALOTYPE_LAYERS(ROW, CALOTYPE_NO_AVERAGED_ROW, CALOTYPE_NO_REPLICAS_ROW, CALOTYPE_NO_MATTE_ROW)

#define CALOTYPE_AVERAGED_LAYERS(ROW)                                                              \
    CALOTYPE_LAYERS(CALOTYPE_NO_FIRST_HIT_ROW, ROW, CALOTYPE_NO_REPLICAS_ROW, CALOTYPE_NO_MATTE_ROW)

/// 32-bit components of a type.
#define CALOTYPE_WORDS_OF_float 1u
#define CALOTYPE_WORDS_OF_uint 1u
#define CALOTYPE_WORDS_OF_vec2 2u
#define CALOTYPE_WORDS_OF_vec3 3u

CALOTYPE_BEGIN_SHARED

#ifdef __cplusplus
#define CALOTYPE_FIELD(name, type, nothing, channels, help) type name{nothing};
#else
#define CALOTYPE_FIELD(name, type, nothing, channels, help) type name;
#endif

/// The surface that a pixel shows: the first on the ray through the centres of the pixel and of the
/// lens, for every film filter. The ray passes through lights that are hidden from the camera, and
/// through points whose alpha is below 1/2.
struct FirstHit {
    CALOTYPE_FIRST_HIT_LAYERS(CALOTYPE_FIELD)
};
#undef CALOTYPE_FIELD

/// The result of the first-hit kernel for a pixel. A storage buffer holds its fields as
/// kFirstHitWords words of 32 bits, one after the other, without padding.
struct FirstHitRecord {
    FirstHit hit; ///< its position is relative to the packed scene's origin
    uint isCut;   ///< 1 if a limit ended the search at a surface that the ray would pass through
};

#define CALOTYPE_ADD_WORDS(name, type, nothing, channels, help) +CALOTYPE_WORDS_OF_##type
CALOTYPE_CONSTANT uint kFirstHitWords = 1u CALOTYPE_FIRST_HIT_LAYERS(CALOTYPE_ADD_WORDS);
#undef CALOTYPE_ADD_WORDS

#ifdef __cplusplus
#define CALOTYPE_FIELD(name, type, channels, help) type name{0.0f};
#else
#define CALOTYPE_FIELD(name, type, channels, help) type name;
#endif

/// What one ray of a pixel shows, or the mean of many. 0 where it shows nothing.
struct Features {
    CALOTYPE_AVERAGED_LAYERS(CALOTYPE_FIELD)
};
#undef CALOTYPE_FIELD

/// The result of the feature kernel for a pixel, in kFeatureWords words as above.
struct FeatureRecord {
    Features features; ///< of one ray
    uint primitive;    ///< number of the first surface that the ray shows, or kNone
    uint isCut;        ///< 1 if a limit ended the search at a surface where the ray would go on
};

#define CALOTYPE_ADD_WORDS(name, type, channels, help) +CALOTYPE_WORDS_OF_##type
CALOTYPE_CONSTANT uint kFeatureWords = 2u CALOTYPE_AVERAGED_LAYERS(CALOTYPE_ADD_WORDS);
#undef CALOTYPE_ADD_WORDS

CALOTYPE_END_SHARED

#ifdef __cplusplus
static_assert(sizeof(calotype::shared::FirstHitRecord) == 4 * calotype::shared::kFirstHitWords);
static_assert(sizeof(calotype::shared::FeatureRecord) == 4 * calotype::shared::kFeatureWords);
#endif

#endif
