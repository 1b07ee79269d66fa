#include "read/json/polygons.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "mesh/mesh_builder.h"
#include "read/json/transform.h"
#include "scene/ranges.h"

namespace calotype {
namespace {

/// Relative to a quad's longest diagonal.
constexpr double kPlaneTolerance = 1e-4;

std::vector<glm::dvec3> readVertices(const JsonObject& object, size_t count) {
    std::vector<glm::dvec3> vertices;
    for (const JsonValue& vertex : object.required("vertices").array(count))
        vertices.push_back(vertex.vector());
    return vertices;
}

/// The four points have equal distances from the plane through their mean whose normal is the cross
/// product of the diagonals.
void checkPlanar(const std::vector<glm::dvec3>& v, const JsonValue& place) {
    const glm::dvec3 diagonal02 = v[2] - v[0];
    const glm::dvec3 diagonal13 = v[3] - v[1];
    const double size = std::max(glm::length(diagonal02), glm::length(diagonal13));
    const glm::dvec3 normal = glm::cross(diagonal02 / size, diagonal13 / size);
    const double distance =
        0.5 * std::abs(glm::dot((v[1] - v[0]) / size, normal)) / glm::length(normal);
    if (distance > kPlaneTolerance)
        place.fail("the corners of the quad do not lie in one plane; use two triangles");
}

/// One for each vertex, or `otherwise` without "uvs". A light has none.
std::vector<glm::dvec2> readUvs(const JsonObject& object, PolygonUse use,
                                const std::vector<glm::dvec2>& otherwise) {
    if (use == PolygonUse::Light)
        return {};
    const auto value = object.optional("uvs");
    if (!value)
        return otherwise;
    std::vector<glm::dvec2> uvs;
    for (const JsonValue& uv : value->array(otherwise.size())) {
        const std::vector<JsonValue> coordinates = uv.array(2);
        uvs.emplace_back(coordinates[0].number(), coordinates[1].number());
    }
    return uvs;
}

Mesh makeMesh(const JsonObject& object, const std::vector<glm::dvec3>& vertices,
              const std::vector<glm::dvec2>& uvs, const std::vector<Mesh::Triangle>& triangles,
              JsonContext& context) {
    const JsonValue place = object.value();
    auto [mesh, dropped] = buildMesh({vertices, {}, uvs, triangles}, readTransform(object),
                                     NormalMode::Flat, place.where());
    if (dropped > 0) {
        context.scene.droppedTriangles += dropped;
        context.warn(place.where(), "half of the quad has no area and was left out");
    }
    return std::move(mesh);
}

/// Texture coordinates, if there are any, have the same indices as the vertices.
Mesh::Triangle flatTriangle(uint32_t a, uint32_t b, uint32_t c, uint32_t material, bool hasUvs) {
    Mesh::Triangle triangle{
        {a, b, c}, {Mesh::kNoNormal, Mesh::kNoNormal, Mesh::kNoNormal}, material};
    if (hasUvs)
        std::ranges::copy(triangle.position, triangle.uv);
    return triangle;
}

std::vector<JsonKey> polygonKeys(size_t corners, const char* description, PolygonUse use,
                                 const char* defaultUvs) {
    std::vector<JsonKey> keys = {
        JsonKey("vertices", arrayType(vectorType(), corners), description).in("metres").required()};
    if (use == PolygonUse::Shape) {
        const JsonType uv = arrayType(numberType(ranges::kTextureCoordinate), 2);
        keys.push_back(JsonKey("uvs", arrayType(namedType("uv", uv), corners),
                               "Texture coordinates [u, v] of each vertex.")
                           .orElseJson(defaultUvs));
    }
    return keys;
}

} // namespace

std::vector<JsonKey> triangleKeys(PolygonUse use) {
    return polygonKeys(3, "The corners, counter-clockwise seen from the front.", use,
                       "[[0, 0], [1, 0], [0, 1]]");
}

std::vector<JsonKey> quadKeys(PolygonUse use) {
    return polygonKeys(4,
                       "The corners, in one plane, counter-clockwise seen from the front. The quad "
                       "becomes the triangles 012 and 023.",
                       use, "[[0, 0], [1, 0], [1, 1], [0, 1]]");
}

Mesh readTriangle(const JsonObject& object, uint32_t material, PolygonUse use,
                  JsonContext& context) {
    const std::vector<glm::dvec3> vertices = readVertices(object, 3);
    const auto uvs = readUvs(object, use, {{0, 0}, {1, 0}, {0, 1}});
    return makeMesh(object, vertices, uvs, {flatTriangle(0, 1, 2, material, !uvs.empty())},
                    context);
}

Mesh readQuad(const JsonObject& object, uint32_t material, PolygonUse use, JsonContext& context) {
    const std::vector<glm::dvec3> vertices = readVertices(object, 4);
    checkPlanar(vertices, object.required("vertices"));
    const auto uvs = readUvs(object, use, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    return makeMesh(object, vertices, uvs,
                    {flatTriangle(0, 1, 2, material, !uvs.empty()),
                     flatTriangle(0, 2, 3, material, !uvs.empty())},
                    context);
}

} // namespace calotype
