#pragma once

#include "scene/load_context.h"

namespace calotype {

/// Warns, once the shapes are read, of the materials that shapes bear and that can reflect more
/// than they receive (see excessAlbedo): the scene file's own each at its place, those of MTL files
/// together at the path of their OBJ.
void warnOfExcessEnergy(LoadContext& context);

} // namespace calotype
