#pragma once

#include "read/json/value.h"
#include "scene/scene.h"

namespace calotype {

/// The scene file's "camera", "film" and "render". All throw SceneError.
Camera readCamera(const JsonValue& value);
FilmSettings readFilm(const JsonValue& value);
RenderDefaults readRender(const JsonValue& value);

} // namespace calotype
