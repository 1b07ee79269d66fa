#pragma once

#include "engine/device_session.h"
#include "engine/render_job.h"
#include "engine/renderer.h"

namespace calotype {

/// Renderer::render with a checked scene. All renders of the library and of the program use it.
RenderResult runJob(const Scene& scene, DeviceKeeper& device, const RenderJob& job,
                    const RenderCallbacks& callbacks);

} // namespace calotype
