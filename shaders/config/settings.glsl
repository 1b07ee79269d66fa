// What a kernel is specialised for beside the scene's features: the device, the sampler, and how
// paths sample light.
#ifndef CALOTYPE_CONFIG_SETTINGS_GLSL
#define CALOTYPE_CONFIG_SETTINGS_GLSL

#include "shared/specialization.h"

#define BEGIN_SETTINGS
#define SETTING(id, type, name, value, source)                                                     \
    layout(constant_id = kConstant##id) const type name = value;
#define END_SETTINGS
#include "shared/setting_table.h"

#endif
