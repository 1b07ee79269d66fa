#pragma once

#include "read/load_context.h"

namespace calotype {

/// A shape has texture coordinates ("uvs", or those of its type); a light has none.
enum class PolygonUse { Shape, Light };

/// A "triangle" or "quad" as a mesh in world space; a quad is the triangles 012 and 023. Throws
/// SceneError for corners without an area, and for a quad's that lie off one plane.
Mesh readTriangle(const JsonObject& object, uint32_t material, PolygonUse use,
                  LoadContext& context);
Mesh readQuad(const JsonObject& object, uint32_t material, PolygonUse use, LoadContext& context);

} // namespace calotype
