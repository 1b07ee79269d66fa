#pragma once

#include <string>

#include "study/page.h"
#include "study/study.h"

namespace calotype {

/// The measurements and the recommended settings of a study as a JSON document (docs/json.md).
std::string toJson(const Study& study, const StudyOrigin& origin);

} // namespace calotype
