#pragma once

#include "image/features.h"
#include "reference/path.h"
#include "reference/random.h"

namespace calotype::reference {

/// What one ray of a pixel shows: it is followed through surfaces that only mirror and refract to
/// the first other one. May be called from several threads.
RayFeatures traceFeatures(const PathSetup& setup, const SampleId& id);

} // namespace calotype::reference
