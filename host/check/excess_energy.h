#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Warns of the materials that shapes use and that can reflect more than they receive (see
/// excessAlbedo): each at its place, those that share one (of MTL files) in one sentence.
void warnOfExcessEnergy(const Scene& scene, Warnings& warnings);

} // namespace calotype
