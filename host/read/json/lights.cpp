#include "read/json/lights.h"

#include <array>
#include <cmath>
#include <numbers>

#include "mesh/mesh_builder.h"
#include "read/json/color.h"
#include "read/json/polygons.h"
#include "read/json/quadrics.h"

namespace calotype {
namespace {

const std::array<std::string, 3> kTypes = {"disk", "triangle", "quad"};
enum Type { kDisk, kTriangle, kQuad };

std::vector<std::string> keysOf(Type type) {
    std::vector<std::string> keys = {"type",  "transform", "radiance",
                                     "power", "two_sided", "visible"};
    if (type == kDisk) {
        keys.insert(keys.end(), {"center", "normal", "radius"});
    } else {
        keys.push_back("vertices");
    }
    return keys;
}

/// One side's, in square metres.
double area(const Disk& disk) { return std::numbers::pi * disk.radius * disk.radius; }

double area(const Mesh& mesh) {
    double sum = 0.0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        sum += triangleArea(mesh.positions[t.position[0]], mesh.positions[t.position[1]],
                            mesh.positions[t.position[2]]);
    }
    return sum;
}

/// From "radiance", or from "power" spread evenly over all sides and directions (Lambert's law).
glm::dvec3 readEmission(const JsonObject& object, double shiningArea) {
    object.exclude("radiance", "power");
    const auto power = object.optional("power");
    if (!power) {
        if (!object.has("radiance")) {
            object.value().fail("lacks \"radiance\" (or \"power\")");
        }
        return readRadiance(object.required("radiance"));
    }
    const glm::dvec3 radiance = readRadiance(*power) / (std::numbers::pi * shiningArea);
    if (!std::isfinite(radiance.x + radiance.y + radiance.z)) {
        power->fail("is too much for so small a light: its radiance is not finite");
    }
    return radiance;
}

} // namespace

Shape readLight(const JsonValue& value, size_t index, LoadContext& context) {
    const auto type = static_cast<Type>(choiceAt(value, "type", kTypes));
    const JsonObject object(value, keysOf(type));
    const bool twoSided = object.boolean("two_sided", false);

    Material material;
    material.name = "light " + std::to_string(index);
    material.emitsFromFrontOnly = !twoSided;
    material.visibleToCamera = object.boolean("visible", true);

    Shape shape;
    shape.place = value.where();
    shape.material = context.addMaterial(material);
    double sideArea = 0.0;
    if (type == kDisk) {
        const Disk disk = readDisk(object);
        sideArea = area(disk);
        shape.geometry = disk;
    } else {
        Mesh mesh = type == kTriangle
                        ? readTriangle(object, shape.material, PolygonUse::Light, context)
                        : readQuad(object, shape.material, PolygonUse::Light, context);
        sideArea = area(mesh);
        shape.geometry = std::move(mesh);
    }
    context.scene.materials[shape.material].emission =
        readEmission(object, twoSided ? 2.0 * sideArea : sideArea);
    return shape;
}

} // namespace calotype
