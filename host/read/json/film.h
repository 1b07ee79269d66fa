#pragma once

#include "read/json/object.h"
#include "scene/scene.h"

namespace calotype {

/// The values of the scene file's "film" and "render".
JsonType filmType();
JsonType renderType();
/// Both throw SceneError.
FilmSettings readFilm(const JsonValue& value);
RenderDefaults readRender(const JsonValue& value);

} // namespace calotype
