// The packed scene's texel buffers, and loadX(index), which reads a struct X from its rows.
#ifndef CALOTYPE_BUFFERS_PACKED_SCENE_GLSL
#define CALOTYPE_BUFFERS_PACKED_SCENE_GLSL

#extension GL_EXT_samplerless_texture_functions : require

#include "buffers/row_words.glsl"
#include "shared/bindings.h"
#include "shared/scene_structs.h"

// Rows of each struct.
#define STRUCT(name) const uint kRowsOf##name = 0u
#define ROW(type, name, words) +1u
#define FIELD(type, name, words)
#define END(name) ;
#include "shared/scene_struct_table.h"

// readX(rows, place): the struct whose first row is at this place.
#define STRUCT(name)                                                                               \
    name read##name(utextureBuffer rows, int place) {                                              \
        name result;                                                                               \
        uvec4 row;
#define ROW(type, name, words)                                                                     \
    row = texelFetch(rows, place++);                                                               \
    FIELD(type, name, words)
#define FIELD(type, name, words) result.name = WORDS_AS_##type(row.words);
#define END(name)                                                                                  \
    return result;                                                                                 \
    }
#include "shared/scene_struct_table.h"

// The buffers, rowsOfX, and loadX(index) of the structs in them.
#define BEGIN_BINDINGS
#define SCENE_ARRAY(id, type, member, people)                                                      \
    SCENE_ROWS(id, type, member, people)                                                           \
    type load##type(uint index) { return read##type(rowsOf##id, int(kRowsOf##type * index)); }
#define SCENE_ROWS(id, type, member, people)                                                       \
    layout(set = 0, binding = kBinding##id) uniform utextureBuffer rowsOf##id;
#define BINDING(id)
#define END_BINDINGS
#include "shared/binding_table.h"

/// A row of the texels of all images: four texels of 8-bit RGBA, or one of four floats.
uvec4 loadTexelRow(uint row) { return texelFetch(rowsOfTexels, int(row)); }

#endif
