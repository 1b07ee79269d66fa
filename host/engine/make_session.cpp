#include "engine/make_session.h"

#include "render/adaptive_session.h"
#include "render/render_session.h"

namespace calotype {

std::unique_ptr<Session> makeSession(BlockTracer& tracer, const RenderSettings& settings,
                                     double maxRadiance) {
    if (settings.isAdaptive)
        return std::make_unique<AdaptiveSession>(tracer, settings, maxRadiance);
    return std::make_unique<RenderSession>(tracer, settings, maxRadiance);
}

} // namespace calotype
