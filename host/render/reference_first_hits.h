#pragma once

#include <cstdint>
#include <functional>

#include "image/first_hit.h"
#include "reference/reference_tracer.h"
#include "settings/render_settings.h"

namespace calotype {

/// The first hits of the crop by the reference tracer, on `threads` >= 1 threads. `onProgress`, if
/// given, is told the share of the work done after every few rows, and may throw to end it.
FirstHitImage referenceFirstHits(const reference::ReferenceTracer& tracer,
                                 const RenderSettings& settings, uint32_t threads,
                                 const std::function<void(double)>& onProgress = {});

} // namespace calotype
