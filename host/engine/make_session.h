#pragma once

#include <memory>

#include "render/block_tracer.h"
#include "render/session.h"
#include "settings/render_settings.h"

namespace calotype {

/// A session with an empty film, adaptive if the settings say so. The tracer must outlive it.
std::unique_ptr<Session> makeSession(BlockTracer& tracer, const RenderSettings& settings,
                                     double maxRadiance);

} // namespace calotype
