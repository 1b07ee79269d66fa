#pragma once

#include "cli/options.h"
#include "engine/render_job.h"

namespace calotype {

/// Prints on standard error what is wrong with the picture, if anything, and how the render ended.
void reportRender(const RenderOptions& options, const RenderOutcome& outcome);

} // namespace calotype
