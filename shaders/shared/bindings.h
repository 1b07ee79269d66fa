// Numbers of the descriptor bindings of set 0.
#ifndef CALOTYPE_SHARED_BINDINGS_H
#define CALOTYPE_SHARED_BINDINGS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

#define BEGIN_BINDINGS CALOTYPE_CONSTANT uint kBindingsBegin = __LINE__ + 1;
#define SCENE_ARRAY(id, type, member, people) BINDING(id)
#define SCENE_ROWS(id, type, member, people) BINDING(id)
#define BINDING(id) CALOTYPE_CONSTANT uint kBinding##id = __LINE__ - kBindingsBegin;
#define END_BINDINGS CALOTYPE_CONSTANT uint kBindingCount = __LINE__ - kBindingsBegin;
#include "shared/binding_table.h"

// With a line between two rows, or a row of two lines, C++ and GLSL would number rows differently.
#ifdef __cplusplus
#define BEGIN_BINDINGS static_assert(kBindingCount == 0
#define SCENE_ARRAY(id, type, member, people) BINDING(id)
#define SCENE_ROWS(id, type, member, people) BINDING(id)
#define BINDING(id) +1
#define END_BINDINGS );
#include "shared/binding_table.h"
#endif

CALOTYPE_END_SHARED

#endif
