#pragma once

#include "cli/options.h"

namespace calotype {

/// Checks before rendering everything that could prevent writing the results. Throws UsageError if
/// outputs have an unknown format, are given twice, or do not fit their options; throws OutputError
/// if a file cannot be written.
void checkOutputs(const RenderOptions& options);
void checkOutputs(const MergeOptions& options);

} // namespace calotype
