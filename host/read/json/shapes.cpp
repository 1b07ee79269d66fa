#include "read/json/shapes.h"

#include <cstddef>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include "base/names.h"
#include "read/json/materials.h"
#include "read/json/mesh.h"
#include "read/json/object_name.h"
#include "read/json/polygons.h"
#include "read/json/quadrics.h"
#include "read/json/transform.h"

namespace calotype {
namespace {

enum class ShapeType { kSphere, kCylinder, kCone, kDisk, kTriangle, kQuad, kMesh };

JsonObjectType shapeTypeOf(const char* name, const char* description, std::vector<JsonKey> keys,
                           std::vector<JsonRule> rules = {}) {
    keys.insert(keys.begin(),
                JsonKey("material", materialNameType(), "The shape's material.").required());
    keys.push_back(transformKey());
    keys.push_back(objectNameKey());
    return chosenType(name, description, std::move(keys), std::move(rules));
}

std::vector<JsonKey> withName(std::vector<JsonKey> keys) {
    keys.push_back(objectNameKey());
    return keys;
}

/// In the order of ShapeType.
const JsonObjectTypes& shapeTypes() {
    static const JsonObjectTypes types = {
        shapeTypeOf("sphere", "A sphere.", sphereKeys()),
        shapeTypeOf("cylinder", "A cylinder, closed by two caps.", cylinderKeys(), {axisRule()}),
        shapeTypeOf("cone", "A cone, closed by its base.", coneKeys(), {axisRule()}),
        shapeTypeOf("disk", "A flat disk.", diskKeys()),
        shapeTypeOf("triangle", "One triangle.", triangleKeys(PolygonUse::Shape)),
        shapeTypeOf("quad", "Two triangles.", quadKeys(PolygonUse::Shape)),
        chosenType("mesh", "The polygons of a model's file.", withName(meshKeys()),
                   {meshMaterialRule()})};
    return types;
}

/// Warns if the material of a shape other than a "mesh" has a displacement.
void warnOfDisplacement(const Shape& shape, JsonContext& context) {
    if (context.displacements[shape.material]) {
        context.warn(shape.place,
                     "the displacement of the material " +
                         inQuotes(context.scene.materials[shape.material].name) +
                         " moves meshes only; this shape stays as it is",
                     "displacements of shapes that are no meshes");
    }
}

/// A shape without the mesh that is being built for it, if any, and the warnings about it so far.
struct BegunShape {
    Shape shape;
    std::optional<BegunObjMesh> mesh;
    Warnings warnings;
};

/// `index` is that in the list of shapes, for the default of its name.
BegunShape beginShape(const JsonValue& value, size_t index, JsonContext& context) {
    const auto type = static_cast<ShapeType>(readType(value, shapeTypes()));
    const JsonObject object(value, shapeTypes()[static_cast<size_t>(type)]);
    BegunShape begun;
    Shape& shape = begun.shape;
    shape.place = value.where();
    shape.name = readObjectName(object, shapeTypes()[static_cast<size_t>(type)].name, index);
    if (type == ShapeType::kMesh) {
        begun.mesh = readMesh(object, context);
        shape.file = object.required("file").text();
        return begun;
    }
    shape.material = findMaterial(object.required("material"), context);
    warnOfDisplacement(shape, context);
    switch (type) {
    case ShapeType::kSphere:
        shape.geometry = readSphere(object);
        break;
    case ShapeType::kCylinder:
        shape.geometry = readCylinder(object);
        break;
    case ShapeType::kCone:
        shape.geometry = readCone(object);
        break;
    case ShapeType::kDisk:
        shape.geometry = readDisk(object);
        break;
    case ShapeType::kTriangle:
        shape.geometry = readTriangle(object, shape.material, PolygonUse::Shape, context);
        break;
    case ShapeType::kQuad:
        shape.geometry = readQuad(object, shape.material, PolygonUse::Shape, context);
        break;
    case ShapeType::kMesh:
        break;
    }
    return begun;
}

/// Adds a shape to the scene, and its warnings.
void addShape(BegunShape& begun, JsonContext& context) {
    context.warnings.append(begun.warnings);
    if (begun.mesh)
        begun.shape.geometry = finishObjMesh(*begun.mesh, context);
    context.scene.shapes.push_back(std::move(begun.shape));
}

} // namespace

JsonType shapeType() { return anyOf(shapeTypes(), "shape"); }

void readShapes(const JsonValue& value, JsonContext& context) {
    // Meshes are built on other threads while further shapes are read. Warnings and the first error
    // are in the order of the shapes nevertheless.
    std::vector<BegunShape> begun;
    std::exception_ptr failure;
    Warnings before = std::exchange(context.warnings, {});
    try {
        for (const JsonValue& shape : value.array()) {
            begun.push_back(beginShape(shape, begun.size(), context));
            begun.back().warnings = std::exchange(context.warnings, {});
        }
    } catch (...) {
        failure = std::current_exception();
    }
    context.warnings = std::move(before);
    for (BegunShape& shape : begun)
        addShape(shape, context);
    if (failure)
        std::rethrow_exception(failure);
}

} // namespace calotype
