#pragma once

#include "cli/options.h"

namespace calotype {

/// Everything that could keep a result from being written is known before rendering starts: throws
/// UsageError where outputs are of no known format, given twice or lack what is asked of them, and
/// OutputError where a file could not be written.
void checkOutputs(const RenderOptions& options);
void checkOutputs(const MergeOptions& options);

} // namespace calotype
