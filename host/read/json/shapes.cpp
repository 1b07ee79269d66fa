#include "read/json/shapes.h"

#include <array>

#include "base/names.h"
#include "read/json/materials.h"
#include "read/json/mesh.h"
#include "read/json/polygons.h"
#include "read/json/quadrics.h"

namespace calotype {
namespace {

const std::array<std::string, 7> kTypes = {"sphere",   "cylinder", "cone", "disk",
                                           "triangle", "quad",     "mesh"};
enum Type { kSphere, kCylinder, kCone, kDisk, kTriangle, kQuad, kMesh };

std::vector<std::string> keysOf(Type type) {
    switch (type) {
    case kSphere:
        return {"type", "material", "transform", "center", "radius"};
    case kCylinder:
        return {"type", "material", "transform", "center", "radius", "height", "axis"};
    case kCone:
        return {"type", "material", "transform", "apex", "height", "slope", "axis"};
    case kDisk:
        return {"type", "material", "transform", "center", "normal", "radius"};
    case kTriangle:
    case kQuad:
        return {"type", "material", "transform", "vertices", "uvs"};
    case kMesh:
        break;
    }
    return {"type", "material", "transform", "file", "materials", "normals", "displacement"};
}

/// Of a shape that is not a "mesh".
void warnOfDisplacement(const Shape& shape, LoadContext& context) {
    if (context.displacements[shape.material]) {
        context.warn(shape.place, "the displacement of the material " +
                                      inQuotes(context.scene.materials[shape.material].name) +
                                      " moves meshes only; this shape stays as it is");
    }
}

} // namespace

Shape readShape(const JsonValue& value, LoadContext& context) {
    const auto type = static_cast<Type>(choiceAt(value, "type", kTypes));
    const JsonObject object(value, keysOf(type));
    Shape shape;
    shape.place = value.where();
    if (type == kMesh) {
        shape.geometry = readMesh(object, context);
        return shape;
    }
    shape.material = findMaterial(object.required("material"), context);
    warnOfDisplacement(shape, context);
    switch (type) {
    case kSphere:
        shape.geometry = readSphere(object);
        break;
    case kCylinder:
        shape.geometry = readCylinder(object);
        break;
    case kCone:
        shape.geometry = readCone(object);
        break;
    case kDisk:
        shape.geometry = readDisk(object);
        break;
    case kTriangle:
        shape.geometry = readTriangle(object, shape.material, PolygonUse::Shape, context);
        break;
    case kQuad:
        shape.geometry = readQuad(object, shape.material, PolygonUse::Shape, context);
        break;
    case kMesh:
        break;
    }
    return shape;
}

} // namespace calotype
