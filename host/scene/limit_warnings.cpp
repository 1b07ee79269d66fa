#include "scene/limit_warnings.h"

#include "scene/coplanar_lights.h"
#include "scene/faint_lights.h"
#include "scene/far_texels.h"
#include "scene/fine_view.h"
#include "scene/small_shapes.h"
#include "scene/thin_quadrics.h"

namespace calotype {

void warnOfLimits(LoadContext& context, const std::string& path) {
    warnOfFaintLights(context, path);
    warnOfCoplanarLights(context, path);
    warnOfFineView(context, path);
    warnOfFarTexels(context);
    warnOfThinQuadrics(context);
    warnOfSmallShapes(context);
}

} // namespace calotype
