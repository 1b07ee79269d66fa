#pragma once

#include "cli/options.h"
#include "cli/output_claims.h"

namespace calotype {

/// Checks before rendering everything that could prevent writing the results. Throws UsageError if
/// outputs have an unknown format, are given twice, are read by the command, or do not fit their
/// options; throws OutputError if a file cannot be written, or another process writes it. The
/// result must live until the outputs are written.
OutputClaims checkOutputs(const RenderOptions& options);
OutputClaims checkOutputs(const MergeOptions& options);
OutputClaims checkOutputs(const DenoiseOptions& options);

} // namespace calotype
