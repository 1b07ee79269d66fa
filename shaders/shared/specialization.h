// Identifiers of the specialization constants: first the features, then the settings.
#ifndef CALOTYPE_SHARED_SPECIALIZATION_H
#define CALOTYPE_SHARED_SPECIALIZATION_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

#define BEGIN_FEATURES CALOTYPE_CONSTANT uint kFeaturesBegin = __LINE__ + 1;
#define FEATURE(id, people) CALOTYPE_CONSTANT uint kFeature##id = __LINE__ - kFeaturesBegin;
#define END_FEATURES CALOTYPE_CONSTANT uint kFeatureCount = __LINE__ - kFeaturesBegin;
#include "shared/feature_table.h"

#define BEGIN_SETTINGS CALOTYPE_CONSTANT uint kSettingsBegin = __LINE__ + 1 - kFeatureCount;
#define SETTING(id, type, name, value, source)                                                     \
    CALOTYPE_CONSTANT uint kConstant##id = __LINE__ - kSettingsBegin;
#define END_SETTINGS CALOTYPE_CONSTANT uint kConstantCount = __LINE__ - kSettingsBegin;
#include "shared/setting_table.h"

// With a line between two rows, or a row of two lines, C++ and GLSL would number rows differently.
#ifdef __cplusplus
#define BEGIN_FEATURES static_assert(kFeatureCount == 0
#define FEATURE(id, people) +1
#define END_FEATURES );
#include "shared/feature_table.h"
#define BEGIN_SETTINGS static_assert(kConstantCount == kFeatureCount
#define SETTING(id, type, name, value, source) +1
#define END_SETTINGS );
#include "shared/setting_table.h"
#endif

CALOTYPE_END_SHARED

#endif
