#pragma once

#include <vector>

#include "settings/settings_table.h"

namespace calotype {

/// The rows of the table of settings, by group.
std::vector<Setting> makeSettingRows();

} // namespace calotype
