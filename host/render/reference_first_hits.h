#pragma once

#include <cstdint>
#include <functional>

#include "image/first_hit.h"
#include "reference/reference_tracer.h"
#include "settings/render_settings.h"

namespace calotype {

/// The first hits of the crop by the reference tracer, on `threads` >= 1 threads. `onProgress`, if
/// given, is called now and then with the share done in [0, 1]; may throw to end the work.
FirstHitImage referenceFirstHits(const reference::ReferenceTracer& tracer,
                                 const RenderSettings& settings, uint32_t threads,
                                 const std::function<void(double)>& onProgress = {});

} // namespace calotype
