#include "check/winding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/names.h"
#include "check/closed_parts.h"
#include "materials/material_kind.h"
#include "scene/place.h"

namespace calotype {
namespace {

/// Volume over area to the power of 3/2; a sphere has 0.094. Below, it is a sheet of two equal
/// sides, or only rounding.
constexpr double kFlat = 1e-9;
/// Limit on the boxes and triangles that are compared with the parts that are wound inward.
constexpr double kMostTests = 2e7;

struct PlacedPart {
    size_t shape;
    MeshPart part;
};

/// By material: whether a surface of it has an inside that differs from its outside.
std::vector<bool> materialsWithInside(const Scene& scene) {
    std::vector<bool> result;
    for (const Material& material : scene.materials)
        result.push_back(!kindOf(material).isOpaque && material.ior != material.exteriorIor);
    return result;
}

bool isInside(const Sphere& sphere, const glm::dvec3& p) {
    return glm::dot(p, p) < sphere.radius * sphere.radius;
}
bool isInside(const Cylinder& cylinder, const glm::dvec3& p) {
    return std::abs(p.y) < 0.5 * cylinder.height && std::hypot(p.x, p.z) < cylinder.radius;
}
bool isInside(const Cone& cone, const glm::dvec3& p) {
    const double share = p.y / cone.height;
    return share > 0.0 && share < 1.0 && std::hypot(p.x, p.z) < cone.slope * std::abs(p.y);
}

/// Whether a solid other than a mesh holds the point.
bool holds(const Shape& shape, const glm::dvec3& point) {
    return std::visit(
        [&](const auto& solid) {
            if constexpr (requires { isInside(solid, point); }) {
                const auto& frame = solid.worldFromObject;
                return isInside(solid,
                                glm::transpose(frame.rotation) * (point - frame.translation));
            } else {
                return false;
            }
        },
        shape.geometry);
}

class WindingCheck {
public:
    WindingCheck(const Scene& scene, Warnings& warnings)
        : scene_(scene), warnings_(warnings), hasInside_(materialsWithInside(scene)) {
        if (std::ranges::find(hasInside_, true) == hasInside_.end())
            return;
        for (size_t i = 0; i < scene.shapes.size(); ++i)
            if (const auto* mesh = std::get_if<Mesh>(&scene.shapes[i].geometry))
                for (MeshPart& part : partsOf(*mesh, hasInside_))
                    parts_.push_back({i, std::move(part)});
    }

    void run() {
        for (size_t begin = 0, end = 0; begin < parts_.size(); begin = end) {
            size_t inward = 0;
            size_t mixed = 0;
            const MeshPart* first = nullptr;
            for (; end < parts_.size() && parts_[end].shape == parts_[begin].shape; ++end) {
                const MeshPart& part = parts_[end].part;
                const bool isMixed = part.isClosed && !part.isOriented;
                const bool isWrong = isMixed || isWronglyInward(parts_[end]);
                mixed += isMixed ? 1 : 0;
                inward += isWrong && !isMixed ? 1 : 0;
                first = isWrong && first == nullptr ? &part : first;
            }
            if (first != nullptr)
                warn(parts_[begin].shape, *first, inward, mixed);
        }
    }

private:
    const Material& materialOf(const MeshPart& part) const {
        return scene_.materials[part.mesh->triangles[part.triangles[0]].material];
    }

    /// Also false if the tests would take too long.
    bool isWronglyInward(const PlacedPart& placed) {
        const MeshPart& part = placed.part;
        const Material& material = materialOf(part);
        if (material.ior < material.exteriorIor) // the outside is glass, so the enclosed space is
            return false;
        if (tests_ > kMostTests || !part.isOriented ||
            part.volume >= -kFlat * std::pow(part.area, 1.5))
            return false;
        glm::dvec3 middle(0.0);
        for (const uint32_t corner : part.mesh->triangles[part.triangles[0]].position)
            middle += part.mesh->positions[corner] / 3.0;
        return !isInsideOthers(middle, part);
    }

    bool isInsideOthers(const glm::dvec3& point, const MeshPart& own) {
        double winding = 0.0;
        tests_ += static_cast<double>(scene_.shapes.size() + parts_.size());
        for (const Shape& shape : scene_.shapes)
            if (hasInside_[shape.material] && holds(shape, point))
                winding += 1.0;
        for (const auto& [shape, part] : parts_) {
            Bounds3d withPoint = part.bounds;
            withPoint.extend(point);
            if (&part == &own || !part.bounds.contains(withPoint))
                continue;
            tests_ += static_cast<double>(part.triangles.size());
            if (tests_ > kMostTests)
                break;
            winding += windingNumber(part, point);
        }
        return winding > 0.5 || tests_ > kMostTests;
    }

    void warn(size_t shapeIndex, const MeshPart& part, size_t inward, size_t mixed) {
        const Shape& shape = scene_.shapes[shapeIndex];
        const std::string name = inQuotes(materialOf(part).name);
        const std::string of = shape.file.empty() ? "" : " of " + inQuotes(shape.file);
        const size_t count = inward + mixed;
        const bool isOne = count == 1;
        const std::string parts = isOne ? "a closed part" : std::to_string(count) + " closed parts";
        const std::string problem =
            mixed == 0
                ? std::string(isOne ? "is" : "are") +
                      " wound inward (the corners of the faces run clockwise, seen from outside), "
                      "so that light passes as if the inside were the outside"
                : std::string(isOne ? "has" : "have") +
                      " faces wound inward beside faces wound outward, so that light passes some "
                      "as if the inside were the outside";
        warnings_.add(
            placeOfShape(scene_, shapeIndex),
            "the material " + name + " is on " + parts + of + " that " + problem +
                "; reverse the order of the corners of " +
                (mixed == 0 ? "the faces, or exchange \"ior\" and \"exterior_ior\"" : "the former"),
            "winding");
    }

    const Scene& scene_;
    Warnings& warnings_;
    std::vector<bool> hasInside_;
    std::vector<PlacedPart> parts_;
    double tests_ = 0.0;
};

} // namespace

void warnOfWinding(const Scene& scene, Warnings& warnings) { WindingCheck(scene, warnings).run(); }

} // namespace calotype
