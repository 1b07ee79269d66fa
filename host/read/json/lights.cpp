#include "read/json/lights.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "mesh/mesh_builder.h"
#include "read/json/color.h"
#include "read/json/object_name.h"
#include "read/json/polygons.h"
#include "read/json/quadrics.h"
#include "read/json/transform.h"

namespace calotype {
namespace {

enum class LightType { kDisk, kTriangle, kQuad };

JsonObjectType lightTypeOf(const char* name, const char* description, std::vector<JsonKey> keys) {
    keys.push_back(transformKey());
    keys.push_back(objectNameKey());
    keys.push_back(JsonKey("radiance", radianceType(), "What it shines with.").in("W/(m^2 sr)"));
    keys.push_back(JsonKey("power", radianceType(), "All that it sends out, in place of radiance.")
                       .in("watts"));
    keys.push_back(
        JsonKey("two_sided", booleanType(), "Whether its back shines too.").orElse(false));
    keys.push_back(
        JsonKey("visible", booleanType(), "Whether camera rays see it; reflections always do.")
            .orElse(true));
    return chosenType(name, description, std::move(keys), {exactlyOne("radiance", "power")});
}

/// In the order of LightType.
const JsonObjectTypes& lightTypes() {
    static const JsonObjectTypes types = {
        lightTypeOf("disk", "A black disk that shines from its front.", diskKeys()),
        lightTypeOf("triangle", "A black triangle that shines from its front.",
                    triangleKeys(PolygonUse::Light)),
        lightTypeOf("quad", "A black quad that shines from its front.",
                    quadKeys(PolygonUse::Light))};
    return types;
}

/// Area of one side, in square metres.
double area(const Disk& disk) { return std::numbers::pi * disk.radius * disk.radius; }

double area(const Mesh& mesh) {
    double sum = 0.0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        sum += triangleArea(mesh.positions[t.position[0]], mesh.positions[t.position[1]],
                            mesh.positions[t.position[2]]);
    }
    return sum;
}

/// From "radiance", or from "power", emitted evenly from all sides (Lambert's law).
glm::dvec3 readEmission(const JsonObject& object, double shiningArea) {
    if (const auto radiance = object.optional("radiance"))
        return readColor(*radiance, ranges::kRadiance);
    const JsonValue power = object.required("power");
    const glm::dvec3 radiance =
        readColor(power, ranges::kRadiance) / (std::numbers::pi * shiningArea);
    if (!std::isfinite(radiance.x + radiance.y + radiance.z))
        power.fail("is too much for so small a light: its radiance is not finite");
    return radiance;
}

} // namespace

JsonType lightType() { return anyOf(lightTypes(), "light"); }

Shape readLight(const JsonValue& value, size_t index, JsonContext& context) {
    const auto type = static_cast<LightType>(readType(value, lightTypes()));
    const JsonObject object(value, lightTypes()[static_cast<size_t>(type)]);
    const bool twoSided = object.boolean("two_sided", false);

    Material material;
    material.name = "light " + std::to_string(index);
    material.place = value.where();
    material.emitsFromFrontOnly = !twoSided;
    material.visibleToCamera = object.boolean("visible", true);

    Shape shape;
    shape.place = value.where();
    shape.name = readObjectName(object, "light", index);
    shape.material = context.addMaterial(material);
    double sideArea = 0.0;
    if (type == LightType::kDisk) {
        const Disk disk = readDisk(object);
        sideArea = area(disk);
        shape.geometry = disk;
    } else {
        Mesh mesh = type == LightType::kTriangle
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
