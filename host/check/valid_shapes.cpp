#include "check/valid_shapes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <variant>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/parallel_chunks.h"
#include "check/require.h"
#include "scene/place.h"

namespace calotype {
namespace {

/// Of a normal's length; interpolation normalises it anyway.
constexpr double kLengthTolerance = 1e-3;

void requireMaterial(const Scene& scene, uint32_t material, const std::string& where) {
    if (material >= scene.materials.size()) {
        throw SceneError(where, "uses material " + std::to_string(material) + " of " +
                                    std::to_string(scene.materials.size()));
    }
}

bool lieBelow(size_t count, std::span<const uint32_t, 3> indices) {
    return std::ranges::all_of(indices, [&](uint32_t index) { return index < count; });
}

bool areAll(uint32_t none, std::span<const uint32_t, 3> indices) {
    return std::ranges::all_of(indices, [&](uint32_t index) { return index == none; });
}

bool verticesExist(const Mesh& mesh, const Mesh::Triangle& t) {
    return lieBelow(mesh.positions.size(), t.position) &&
           (areAll(Mesh::kNoNormal, t.normal) || lieBelow(mesh.normals.size(), t.normal)) &&
           (areAll(Mesh::kNoUv, t.uv) || lieBelow(mesh.uvs.size(), t.uv));
}

/// The vertices of the triangle must exist.
bool normalsAreUnit(const Mesh& mesh, const Mesh::Triangle& triangle) {
    return std::ranges::all_of(triangle.normal, [&](uint32_t index) {
        return index == Mesh::kNoNormal ||
               std::abs(glm::length(mesh.normals[index]) - 1.0) <= kLengthTolerance;
    });
}

struct ShapeCheck {
    const Scene& scene;
    const Shape& shape;
    const std::string where;

    void operator()(const Sphere& sphere) const {
        requireSolid(sphere.worldFromObject);
        require(ranges::kPositive, sphere.radius, where + "/radius");
    }
    void operator()(const Cylinder& cylinder) const {
        requireSolid(cylinder.worldFromObject);
        require(ranges::kPositive, cylinder.radius, where + "/radius");
        require(ranges::kPositive, cylinder.height, where + "/height");
    }
    void operator()(const Cone& cone) const {
        requireSolid(cone.worldFromObject);
        require(ranges::kPositive, std::abs(cone.height), where + "/height");
        require(ranges::kPositive, cone.slope, where + "/slope");
    }
    void operator()(const Disk& disk) const {
        requireSolid(disk.worldFromObject);
        require(ranges::kPositive, disk.radius, where + "/radius");
    }
    void operator()(const Mesh& mesh) const {
        if (mesh.triangles.empty())
            throw SceneError(where, "has no triangles");
        requireVertices(mesh);
        if (trianglesAreValid(mesh))
            return;
        for (const Mesh::Triangle& triangle : mesh.triangles) { // finds the first fault
            if (!verticesExist(mesh, triangle))
                throw SceneError(where, "has a triangle with a vertex that does not exist");
            if (!normalsAreUnit(mesh, triangle))
                throw SceneError(where, "has a normal whose length is not 1");
            requireMaterial(scene, triangle.material, where);
        }
    }

private:
    bool trianglesAreValid(const Mesh& mesh) const {
        std::atomic<bool> areValid = true;
        parallelChunks(mesh.triangles.size(), allCores(), [&](uint64_t first, uint64_t last) {
            const std::span part(mesh.triangles.data() + first, last - first);
            if (!std::ranges::all_of(part, [&](const Mesh::Triangle& triangle) {
                    return verticesExist(mesh, triangle) && normalsAreUnit(mesh, triangle) &&
                           triangle.material < scene.materials.size();
                }))
                areValid = false;
        });
        return areValid;
    }

    void requireSolid(const RigidTransform& worldFromObject) const {
        requireMaterial(scene, shape.material, where);
        requireOrthonormal(worldFromObject.rotation, where);
        require(ranges::kAnyNumber, worldFromObject.translation, where + "/translation");
    }

    void requireVertices(const Mesh& mesh) const {
        for (const glm::dvec3& position : mesh.positions)
            if (!std::isfinite(position.x + position.y + position.z))
                throw SceneError(where, "has a position that is not finite");
        for (const glm::dvec2& uv : mesh.uvs) {
            require(ranges::kTextureCoordinate, uv.x, where + "/uvs");
            require(ranges::kTextureCoordinate, uv.y, where + "/uvs");
        }
    }
};

} // namespace

void requireValidShapes(const Scene& scene) {
    for (const Shape& shape : scene.shapes)
        std::visit(ShapeCheck{scene, shape, placeOf(scene, shape)}, shape.geometry);
}

} // namespace calotype
