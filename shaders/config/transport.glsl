// How light is looked for along a path, as the kernel was specialised.
#ifndef CALOTYPE_CONFIG_TRANSPORT_GLSL
#define CALOTYPE_CONFIG_TRANSPORT_GLSL

#include "shared/bindings.h"

layout(constant_id = kConstantMis) const bool usesMis = true;
layout(constant_id = kConstantRoulette) const bool usesRoulette = true;
layout(constant_id = kConstantClampsIndirect) const bool clampsIndirect = true;

#endif
