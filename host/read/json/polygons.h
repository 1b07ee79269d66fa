#pragma once

#include <vector>

#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// A shape has texture coordinates ("uvs", or those of its type); a light has none.
enum class PolygonUse { Shape, Light };

/// The keys of their geometry, without "transform".
std::vector<JsonKey> triangleKeys(PolygonUse use);
std::vector<JsonKey> quadKeys(PolygonUse use);

/// A "triangle" or "quad" as a mesh in world space; a quad is the triangles 012 and 023. Throws
/// SceneError for corners without an area, and for a quad that is not flat.
Mesh readTriangle(const JsonObject& object, uint32_t material, PolygonUse use,
                  JsonContext& context);
Mesh readQuad(const JsonObject& object, uint32_t material, PolygonUse use, JsonContext& context);

} // namespace calotype
