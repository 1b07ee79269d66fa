#include "pack/pack_shapes.h"

#include <cmath>
#include <numbers>
#include <type_traits>

#include <glm/geometric.hpp>

#include "base/check.h"

namespace calotype {
namespace {

shared::Quadric withFrame(const RigidTransform& worldFromObject, const glm::dvec3& origin) {
    shared::Quadric quadric{};
    quadric.center = packPosition(worldFromObject.translation, origin);
    quadric.axisX = glm::vec3(worldFromObject.rotation[0]);
    quadric.axisY = glm::vec3(worldFromObject.rotation[1]);
    quadric.axisZ = glm::vec3(worldFromObject.rotation[2]);
    return quadric;
}

/// The centre is moved so that, after rounding of the radius, the side of the surface that faces
/// the packed scene's origin stays in place.
shared::Quadric pack(const Sphere& sphere, const glm::dvec3& origin) {
    shared::Quadric quadric = withFrame(sphere.worldFromObject, origin);
    quadric.kind = shared::kSphere;
    quadric.radius = static_cast<float>(sphere.radius);
    const glm::dvec3 exact = sphere.worldFromObject.translation - origin;
    const double distance = glm::length(exact);
    const double excess = static_cast<double>(quadric.radius) - sphere.radius;
    const glm::dvec3 center = distance > 0.0 ? exact + exact * (excess / distance) : exact;
    quadric.center = glm::vec3(center);
    quadric.centerRest = glm::vec3(center - glm::dvec3(quadric.center));
    return quadric;
}

shared::Quadric pack(const Cylinder& cylinder, const glm::dvec3& origin) {
    shared::Quadric quadric = withFrame(cylinder.worldFromObject, origin);
    quadric.kind = shared::kCylinder;
    quadric.radius = static_cast<float>(cylinder.radius);
    quadric.extent = static_cast<float>(cylinder.height);
    return quadric;
}

shared::Quadric pack(const Cone& cone, const glm::dvec3& origin) {
    shared::Quadric quadric = withFrame(cone.worldFromObject, origin);
    quadric.kind = shared::kCone;
    quadric.radius = static_cast<float>(cone.slope * std::abs(cone.height));
    quadric.extent = static_cast<float>(cone.height);
    quadric.slope = static_cast<float>(cone.slope);
    return quadric;
}

shared::Quadric pack(const Disk& disk, const glm::dvec3& origin) {
    shared::Quadric quadric = withFrame(disk.worldFromObject, origin);
    quadric.kind = shared::kDisk;
    quadric.radius = static_cast<float>(disk.radius);
    return quadric;
}

/// Unit normal of the triangle's front; zero if it has no area. Computed from the two shorter
/// edges, so that for a needle it does not depend on the rounding of the longest.
glm::dvec3 normalOf(const glm::dvec3& v0, const glm::dvec3& v1, const glm::dvec3& v2) {
    const glm::dvec3 edges[] = {v1 - v0, v2 - v1, v0 - v2};
    int longest = 0;
    for (int i = 1; i < 3; ++i)
        longest =
            glm::dot(edges[i], edges[i]) > glm::dot(edges[longest], edges[longest]) ? i : longest;
    const glm::dvec3 normal = glm::cross(edges[(longest + 1) % 3], edges[(longest + 2) % 3]);
    const double length = glm::length(normal);
    return length > 0.0 ? normal / length : glm::dvec3(0.0);
}

void setNormal(shared::Triangle& triangle, const glm::dvec3& normal) {
    triangle.normalX = static_cast<float>(normal.x);
    triangle.normalY = static_cast<float>(normal.y);
    triangle.normalZ = static_cast<float>(normal.z);
}

bool hasNormal(const shared::Triangle& triangle) {
    return triangle.normalX != 0.0f || triangle.normalY != 0.0f || triangle.normalZ != 0.0f;
}

} // namespace

shared::Triangle packTriangle(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2) {
    shared::Triangle packed{};
    packed.v0 = v0;
    packed.v1 = v1;
    packed.v2 = v2;
    setNormal(packed, normalOf(glm::dvec3(v0), glm::dvec3(v1), glm::dvec3(v2)));
    packed.light = shared::kNone;
    return packed;
}

shared::Triangle packTriangle(const Mesh& mesh, uint32_t triangle, const glm::dvec3& origin,
                              uint32_t number) {
    const Mesh::Triangle& source = mesh.triangles[triangle];
    const glm::dvec3& v0 = mesh.positions[source.position[0]];
    const glm::dvec3& v1 = mesh.positions[source.position[1]];
    const glm::dvec3& v2 = mesh.positions[source.position[2]];
    shared::Triangle packed =
        packTriangle(packPosition(v0, origin), packPosition(v1, origin), packPosition(v2, origin));
    if (!hasNormal(packed))
        setNormal(packed, normalOf(v0, v1, v2));
    packed.material = source.material;
    packed.id = number;
    return packed;
}

shared::TriangleNormals packTriangleNormals(const Mesh& mesh, uint32_t triangle) {
    shared::TriangleNormals packed{};
    const Mesh::Triangle& source = mesh.triangles[triangle];
    if (source.normal[0] == Mesh::kNoNormal)
        return packed;
    packed.n0 = glm::vec3(mesh.normals[source.normal[0]]);
    packed.n1 = glm::vec3(mesh.normals[source.normal[1]]);
    packed.n2 = glm::vec3(mesh.normals[source.normal[2]]);
    return packed;
}

shared::TriangleUvs packTriangleUvs(const Mesh& mesh, uint32_t triangle) {
    shared::TriangleUvs packed{};
    const Mesh::Triangle& source = mesh.triangles[triangle];
    if (source.uv[0] == Mesh::kNoUv)
        return packed;
    packed.uv0 = glm::vec2(mesh.uvs[source.uv[0]]);
    packed.uv1 = glm::vec2(mesh.uvs[source.uv[1]]);
    packed.uv2 = glm::vec2(mesh.uvs[source.uv[2]]);
    return packed;
}

shared::Quadric packQuadric(const Shape& shape, const glm::dvec3& origin, uint32_t number) {
    CALOTYPE_CHECK_EQ(std::holds_alternative<Mesh>(shape.geometry), false);
    shared::Quadric packed{};
    std::visit(
        [&]<typename Geometry>(const Geometry& geometry) {
            if constexpr (!std::is_same_v<Geometry, Mesh>)
                packed = pack(geometry, origin);
        },
        shape.geometry);
    packed.material = shape.material;
    packed.light = shared::kNone;
    packed.id = number;
    return packed;
}

double areaOf(const shared::Triangle& triangle) {
    const glm::dvec3 v0(triangle.v0);
    return 0.5 *
           glm::length(glm::cross(glm::dvec3(triangle.v1) - v0, glm::dvec3(triangle.v2) - v0));
}

double areaOf(const shared::Quadric& quadric) {
    constexpr double kPi = std::numbers::pi;
    const double r = quadric.radius;
    const double h = std::abs(quadric.extent);
    switch (quadric.kind) {
    case shared::kSphere:
        return 4.0 * kPi * r * r;
    case shared::kCylinder:
        return 2.0 * kPi * r * (h + r);
    case shared::kCone:
        return kPi * r * (r + std::hypot(r, h));
    default:
        return kPi * r * r;
    }
}

} // namespace calotype
