#pragma once

#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// The value of the scene file's "materials".
JsonType materialsType();

/// Reads the scene file's "materials" into Scene::materials, in the order of their names, and their
/// displacements into JsonContext::displacements.
void readMaterials(const JsonValue& value, JsonContext& context);

/// The index of the material that `reference` names. Throws SceneError if there is none.
uint32_t findMaterial(const JsonValue& reference, const JsonContext& context);

} // namespace calotype
