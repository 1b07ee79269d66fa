#include "reference/geometry.h"

#include <type_traits>
#include <variant>

#include <glm/geometric.hpp>

#include "base/check.h"
#include "reference/mesh_surface.h"
#include "reference/quadric.h"
#include "reference/rounding.h"
#include "reference/triangle.h"

namespace calotype::reference {
namespace {

/// Calls ofMesh(mesh, triangle) or ofQuadric(sphere, cylinder, cone or disk).
template <typename OfMesh, typename OfQuadric>
auto dispatch(const Scene& scene, const PrimitiveName& name, OfMesh&& ofMesh,
              OfQuadric&& ofQuadric) {
    return std::visit(
        [&]<typename Geometry>(const Geometry& geometry) {
            if constexpr (std::is_same_v<Geometry, Mesh>)
                return ofMesh(geometry, geometry.triangles[name.triangle]);
            else
                return ofQuadric(geometry);
        },
        scene.shapes[name.shape].geometry);
}

std::vector<PrimitiveName> namePrimitives(const Scene& scene) {
    std::vector<PrimitiveName> names;
    for (uint32_t shape = 0; shape < scene.shapes.size(); ++shape) {
        const Mesh* mesh = std::get_if<Mesh>(&scene.shapes[shape].geometry);
        const size_t count = mesh ? mesh->triangles.size() : 1;
        for (uint32_t triangle = 0; triangle < count; ++triangle)
            names.push_back({shape, triangle});
    }
    return names;
}

/// The bounds in world space of a box in another frame.
Bounds3d inWorld(const Bounds3d& box, const RigidTransform& worldFromObject) {
    Bounds3d bounds;
    for (const double x : {box.lower.x, box.upper.x})
        for (const double y : {box.lower.y, box.upper.y})
            for (const double z : {box.lower.z, box.upper.z})
                bounds.extend(worldFromObject.point({x, y, z}));
    return bounds;
}

std::vector<Bounds3d> boxesOf(const Scene& scene, const std::vector<PrimitiveName>& names) {
    std::vector<Bounds3d> boxes;
    boxes.reserve(names.size());
    for (const PrimitiveName& name : names) {
        boxes.push_back(dispatch(
            scene, name,
            [](const Mesh& mesh, const Mesh::Triangle& triangle) {
                Bounds3d box;
                for (const glm::dvec3& corner : cornersOf(mesh, triangle))
                    box.extend(corner);
                return box;
            },
            [](const auto& quadric) {
                return inWorld(boundsOf(quadric), quadric.worldFromObject);
            }));
    }
    return boxes;
}

/// The rotation is orthogonal, so a product from the left applies its inverse.
LocalRay inFrame(const RigidTransform& worldFromObject, const Ray& ray) {
    const glm::dvec3 origin = (ray.origin - worldFromObject.translation) * worldFromObject.rotation;
    return {origin, ray.direction * worldFromObject.rotation,
            kSurfaceTolerance * glm::length(origin)};
}

Surface inWorld(const LocalSurface& local, const RigidTransform& worldFromObject) {
    Surface surface{};
    surface.position = worldFromObject.point(local.position);
    surface.ng = glm::normalize(worldFromObject.direction(local.normal));
    surface.ns = surface.ng;
    surface.horizon = surface.ng;
    surface.uv = local.uv;
    surface.dpdu = worldFromObject.direction(local.dpdu);
    surface.dpdv = worldFromObject.direction(local.dpdv);
    return surface;
}

} // namespace

Geometry::Geometry(const Scene& scene)
    : scene_(scene), names_(namePrimitives(scene)), tree_(boxesOf(scene, names_)) {}

uint32_t Geometry::materialOf(uint32_t number) const {
    const PrimitiveName name = names_[number];
    return dispatch(
        scene_, name, [](const Mesh&, const Mesh::Triangle& triangle) { return triangle.material; },
        [&](const auto&) { return scene_.shapes[name.shape].material; });
}

double Geometry::areaOf(uint32_t number) const {
    return dispatch(
        scene_, names_[number],
        [](const Mesh& mesh, const Mesh::Triangle& triangle) {
            return reference::areaOf(cornersOf(mesh, triangle));
        },
        [](const auto& quadric) { return reference::areaOf(quadric); });
}

glm::dvec2 Geometry::uvAt(uint32_t number, const glm::dvec3& point) const {
    return dispatch(
        scene_, names_[number],
        [&](const Mesh& mesh, const Mesh::Triangle& triangle) {
            return reference::uvAt(mesh, triangle, weightsAt(cornersOf(mesh, triangle), point));
        },
        [&](const auto& quadric) {
            const RigidTransform& worldFromObject = quadric.worldFromObject;
            const glm::dvec3 p = (point - worldFromObject.translation) * worldFromObject.rotation;
            return surfaceNear(quadric, p).uv;
        });
}

std::optional<Hit> Geometry::closest(const Ray& ray) const {
    const View view(ray);
    double reach = ray.length;
    std::optional<Hit> found;
    tree_.forEachAlong(ray, reach, [&](uint32_t number) {
        const std::optional<double> t = dispatch(
            scene_, names_[number],
            [&](const Mesh& mesh, const Mesh::Triangle& triangle) -> std::optional<double> {
                const auto hit = intersect(cornersOf(mesh, triangle), view);
                return hit ? std::optional(hit->t) : std::nullopt;
            },
            [&](const auto& quadric) {
                return intersect(quadric, inFrame(quadric.worldFromObject, ray));
            });
        const bool isTie = found && t == found->t;
        if (t && (*t < reach || (isTie && number < found->primitive))) {
            reach = *t;
            found = Hit{*t, number};
        }
    });
    return found;
}

Surface Geometry::surface(const Hit& hit, const Ray& ray) const {
    Surface surface = dispatch(
        scene_, names_[hit.primitive],
        [&](const Mesh& mesh, const Mesh::Triangle& triangle) {
            const auto again = intersect(cornersOf(mesh, triangle), View(ray));
            CALOTYPE_CHECK_EQ(again.has_value(), true);
            return surfaceAt(mesh, triangle, again->weights, ray.direction);
        },
        [&](const auto& quadric) {
            const LocalRay local = inFrame(quadric.worldFromObject, ray);
            const glm::dvec3 p = local.origin + hit.t * local.direction;
            return inWorld(surfaceNear(quadric, p), quadric.worldFromObject);
        });
    surface.material = materialOf(hit.primitive);
    surface.primitive = hit.primitive;
    return surface;
}

} // namespace calotype::reference
