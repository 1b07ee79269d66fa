#pragma once

#include "cli/options.h"
#include "engine/renderer.h"

namespace calotype {

/// Prints on standard error how the render ended, and whether it reached its target error.
void reportRender(const RenderOptions& options, const RenderResult& result);

} // namespace calotype
