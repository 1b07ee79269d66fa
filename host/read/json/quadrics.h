#pragma once

#include <vector>

#include "read/json/object.h"
#include "scene/scene.h"

namespace calotype {

/// The keys of the geometry of quadrics and disks, without "transform".
std::vector<JsonKey> sphereKeys();
std::vector<JsonKey> cylinderKeys();
std::vector<JsonKey> coneKeys();
std::vector<JsonKey> diskKeys();

/// "axis" excludes a transform.
JsonRule axisRule();

/// The geometry in world space, from objects with those keys and "transform". All throw SceneError.
Sphere readSphere(const JsonObject& object);
Cylinder readCylinder(const JsonObject& object);
Cone readCone(const JsonObject& object);
Disk readDisk(const JsonObject& object);

} // namespace calotype
