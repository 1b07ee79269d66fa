#pragma once

#include <string>

#include "study/study.h"

namespace calotype {

/// The curves of a study, a line a point, with a heading.
std::string toCsv(const Study& study);

} // namespace calotype
