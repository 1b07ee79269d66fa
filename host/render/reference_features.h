#pragma once

#include <cstdint>
#include <functional>

#include "image/features.h"
#include "reference/reference_tracer.h"
#include "settings/render_settings.h"

namespace calotype {

/// The features of the crop by the reference tracer, as FeaturePass::run, on `threads` >= 1
/// threads. `onPrimitives` is called on the thread of the caller.
FeatureImage referenceFeatures(const reference::ReferenceTracer& tracer,
                               const RenderSettings& settings, uint32_t rays, uint32_t threads,
                               const std::function<void(double)>& onProgress = {},
                               const OnPrimitives& onPrimitives = {});

} // namespace calotype
