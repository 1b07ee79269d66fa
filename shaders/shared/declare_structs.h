// Include this before a table of structs: then the table declares them. A table names each field of
// a struct once:
//     STRUCT(Name)
//     ROW(vec3, position, xyz)  the first field of a row of 16 bytes
//     FIELD(float, error, w)    a field of the same row: its type, name and place in the row
//     END(Name)
// Full rows make the C++, std140, std430 and scalar layouts equal. To read a table in another way,
// define STRUCT, ROW, FIELD and END before it. The table undefines them at its end.
//
// No include guard: each table needs this file again.
#include "shared/types.h"

#define STRUCT(name) struct name {
#define ROW(type, name, words) type name;
#define FIELD(type, name, words) type name;
#ifdef __cplusplus
#define END(name)                                                                                  \
    }                                                                                              \
    ;                                                                                              \
    static_assert(sizeof(name) % 16 == 0);
#else
#define END(name)                                                                                  \
    }                                                                                              \
    ;
#endif
