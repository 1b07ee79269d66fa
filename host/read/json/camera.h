#pragma once

#include "read/json/object.h"
#include "scene/scene.h"

namespace calotype {

/// The value of the scene file's "camera".
JsonType cameraType();
/// Throws SceneError.
Camera readCamera(const JsonValue& value);

} // namespace calotype
