#pragma once

#include "base/warnings.h"
#include "scene/scene.h"

namespace calotype {

/// Warns of closed parts of meshes whose material has an inside and an outside, and whose faces are
/// wound inward, or some inward and some outward. The inner walls of hollow glass, which are wound
/// inward because they are inside glass, are right. Parts that are not closed are not judged.
void warnOfWinding(const Scene& scene, Warnings& warnings);

} // namespace calotype
