// The buffer of parked tasks. It is read and written by whole rows, because llvmpipe compiles each
// access to a storage buffer to a loop over the lanes.
#ifndef CALOTYPE_KERNELS_PARKED_TASKS_GLSL
#define CALOTYPE_KERNELS_PARKED_TASKS_GLSL

#include "buffers/row_words.glsl"
#include "kernels/parked_task.h"
#include "shared/bindings.h"

layout(set = 0, binding = kBindingParkedTasks) buffer ParkedTasks { uvec4 parkedRows[]; };

#define STRUCT(name) const uint kRowsOf##name = 0u
#define ROW(type, name, words) +1u
#define FIELD(type, name, words)
#define END(name) ;
#include "kernels/parked_task_table.h"

#define STRUCT(name)                                                                               \
    name load##name(uint index) {                                                                  \
        uint place = kRowsOf##name * index;                                                        \
        name result;                                                                               \
        uvec4 row;
#define ROW(type, name, words)                                                                     \
    row = parkedRows[place++];                                                                     \
    FIELD(type, name, words)
#define FIELD(type, name, words) result.name = WORDS_AS_##type(row.words);
#define END(name)                                                                                  \
    return result;                                                                                 \
    }
#include "kernels/parked_task_table.h"

#define STRUCT(name)                                                                               \
    void store##name(uint index, name value) {                                                     \
        uvec4 rows[kRowsOf##name];                                                                 \
        int last = -1;
#define ROW(type, name, words)                                                                     \
    last++;                                                                                        \
    FIELD(type, name, words)
#define FIELD(type, name, words) rows[last].words = wordsOf(value.name);
#define END(name)                                                                                  \
    for (uint i = 0u; i < kRowsOf##name; ++i)                                                      \
        parkedRows[kRowsOf##name * index + i] = rows[i];                                           \
    }
#include "kernels/parked_task_table.h"

#endif
