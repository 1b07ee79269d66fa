#pragma once

#include "read/load_context.h"

namespace calotype {

/// The scene file's "materials" into Scene::materials, in the order of their names, and their
/// displacements into LoadContext::displacements. Warns of those that reflect more light than they
/// receive.
void readMaterials(const JsonValue& value, LoadContext& context);

/// The index of the material that `reference` names. Throws SceneError if there is none.
uint32_t findMaterial(const JsonValue& reference, const LoadContext& context);

} // namespace calotype
