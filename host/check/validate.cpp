#include "check/validate.h"

#include <memory>
#include <vector>

#include "base/parallel_for.h"
#include "base/task_pool.h"
#include "check/black_picture.h"
#include "check/camera_precision.h"
#include "check/coplanar_lights.h"
#include "check/excess_energy.h"
#include "check/light_precision.h"
#include "check/radiance_range.h"
#include "check/small_shapes.h"
#include "check/texture_precision.h"
#include "check/thin_quadrics.h"
#include "check/valid_camera.h"
#include "check/valid_materials.h"
#include "check/valid_shapes.h"
#include "check/winding.h"

namespace calotype {

namespace {

/// In the order of their warnings.
constexpr void (*kChecks[])(const Scene& scene, Warnings& warnings) = {
    warnOfExcessEnergy,    warnOfLightPrecision,   warnOfCoplanarLights,
    warnOfCameraPrecision, warnOfTexturePrecision, warnOfThinQuadrics,
    warnOfSmallShapes,     warnOfWinding,          warnOfBlackPicture};

} // namespace

void validate(const Scene& scene, Warnings& warnings) {
    requireValidCamera(scene);
    requireValidMaterials(scene);
    requireValidShapes(scene);
    requireRadianceInRange(scene);
    TaskPool pool(allCores());
    std::vector<std::shared_ptr<TaskOf<Warnings>>> tasks;
    for (const auto check : kChecks)
        tasks.push_back(pool.add(0, [&scene, check](const OnProgress&) {
            Warnings found;
            check(scene, found);
            return found;
        }));
    for (const auto& task : tasks)
        warnings.append(pool.finish(*task));
}

} // namespace calotype
