#include "scene/coplanar_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include <glm/geometric.hpp>

namespace calotype {
namespace {

/// Of a light's distance from the camera: the device tells surfaces apart that lie so far from each
/// other (CoplanarLightTest in tests/extremes), and mixes some that lie a tenth as far.
constexpr double kGap = 1e-6;
constexpr double kMostPairs = 1e7;
constexpr size_t kMostNamed = 5; ///< lights, lest a grid of lamps fill the screen

/// A triangle or a disk.
struct Facet {
    size_t shape = 0;
    glm::dvec3 center{0.0};
    glm::dvec3 normal{0.0};              ///< unit
    std::array<glm::dvec3, 3> corners{}; ///< of a disk, points on its rim
    double radius = 0.0;                 ///< of a disk; 0 for a triangle
    bool shines = false;

    double distanceFromPlane(const glm::dvec3& point) const {
        return std::abs(glm::dot(normal, point - center));
    }

    /// Of a point in the plane.
    bool contains(const glm::dvec3& point) const {
        if (radius > 0.0) {
            return glm::distance(point, center) < radius;
        }
        for (size_t i = 0; i < 3; ++i) {
            const glm::dvec3 edge = corners[(i + 1) % 3] - corners[i];
            if (glm::dot(glm::cross(edge, point - corners[i]), normal) < 0.0) {
                return false;
            }
        }
        return true;
    }
};

Facet facetOf(const Disk& disk) {
    const glm::dmat3& frame = disk.worldFromObject.rotation;
    Facet facet;
    facet.center = disk.worldFromObject.translation;
    facet.normal = frame[1];
    facet.radius = disk.radius;
    facet.corners = {facet.center + disk.radius * frame[0], facet.center + disk.radius * frame[2],
                     facet.center - disk.radius * (frame[0] + frame[2]) * std::sqrt(0.5)};
    return facet;
}

Facet facetOf(const Mesh& mesh, const Mesh::Triangle& triangle) {
    Facet facet;
    for (size_t i = 0; i < 3; ++i) {
        facet.corners[i] = mesh.positions[triangle.position[i]];
        facet.center += facet.corners[i] / 3.0;
    }
    facet.normal = glm::normalize(
        glm::cross(facet.corners[1] - facet.corners[0], facet.corners[2] - facet.corners[0]));
    return facet;
}

/// Calls visit(facet) for everything flat in the scene.
template <typename Visit>
void forEachFacet(const Scene& scene, const Visit& visit) {
    const auto shines = [&](uint32_t material) {
        return scene.materials[material].emission != glm::dvec3(0.0);
    };
    for (size_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        const auto visitOne = [&](Facet facet, uint32_t material) {
            facet.shape = i;
            facet.shines = shines(material);
            visit(facet);
        };
        if (const auto* disk = std::get_if<Disk>(&shape.geometry)) {
            visitOne(facetOf(*disk), shape.material);
        } else if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
            for (const Mesh::Triangle& triangle : mesh->triangles) {
                visitOne(facetOf(*mesh, triangle), triangle.material);
            }
        }
    }
}

/// Points within, whatever the facet's kind.
std::array<glm::dvec3, 4> innerPoints(const Facet& facet) {
    const auto halfWay = [&](size_t corner) {
        return 0.5 * (facet.center + facet.corners[corner]);
    };
    return {facet.center, halfWay(0), halfWay(1), halfWay(2)};
}

bool overlap(const Facet& a, const Facet& b) {
    return std::ranges::any_of(innerPoints(a), [&](const auto& p) { return b.contains(p); }) ||
           std::ranges::any_of(innerPoints(b), [&](const auto& p) { return a.contains(p); });
}

bool isInPlaneOf(const Facet& light, const Facet& other, double tolerance) {
    return other.distanceFromPlane(light.center) < tolerance &&
           std::ranges::all_of(light.corners, [&](const glm::dvec3& corner) {
               return other.distanceFromPlane(corner) < tolerance;
           });
}

void warn(LoadContext& context, const Facet& light, const Facet& other, double gap) {
    std::ostringstream message;
    message.precision(1);
    message << "lies in the plane of " << context.scene.shapes[other.shape].place
            << ", so that rounding decides which of the two is seen; move it off by " << gap
            << " m or more";
    context.warn(context.scene.shapes[light.shape].place, message.str());
}

} // namespace

void warnOfCoplanarLights(LoadContext& context, const std::string& path) {
    const Scene& scene = context.scene;
    std::vector<Facet> lights;
    double facets = 0.0;
    forEachFacet(scene, [&](const Facet& facet) {
        facets += 1.0;
        if (facet.shines) {
            lights.push_back(facet);
        }
    });
    if (static_cast<double>(lights.size()) * facets > kMostPairs) {
        return;
    }
    std::set<size_t> coplanar;
    forEachFacet(scene, [&](const Facet& other) {
        for (const Facet& light : lights) {
            const double gap = kGap * glm::distance(light.center, scene.camera.position);
            if (light.shape != other.shape && !coplanar.contains(light.shape) &&
                isInPlaneOf(light, other, gap) && overlap(light, other)) {
                coplanar.insert(light.shape);
                if (coplanar.size() <= kMostNamed) {
                    warn(context, light, other, gap);
                }
            }
        }
    });
    if (coplanar.size() > kMostNamed) {
        context.warn(path, std::to_string(coplanar.size() - kMostNamed) +
                               " more lights lie in the plane of another shape in the same way");
    }
}

} // namespace calotype
