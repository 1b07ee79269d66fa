#pragma once

#include "read/json/value.h"
#include "scene/scene.h"

namespace calotype {

/// The geometry of quadrics and disks, in world space. Keys that they share with other shapes
/// ("type", "material") are the caller's. All throw SceneError.
Sphere readSphere(const JsonObject& object);
Cylinder readCylinder(const JsonObject& object);
Cone readCone(const JsonObject& object);
Disk readDisk(const JsonObject& object);

} // namespace calotype
