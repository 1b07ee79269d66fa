#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Warns of used materials that can reflect more light than they receive (see excessAlbedo): one
/// sentence for each place; materials of MTL files share one.
void warnOfExcessEnergy(const Scene& scene, Warnings& warnings);

} // namespace calotype
