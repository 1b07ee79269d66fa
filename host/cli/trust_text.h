#pragma once

#include <string>

#include "film/error_estimate.h"

namespace calotype {

/// A remark behind an error that is shown: " (too few samples to tell)", " (not to be trusted)", or
/// nothing if it is trusted.
std::string trustText(const ErrorEstimate& error);

} // namespace calotype
