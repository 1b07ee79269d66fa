#include "check/validate.h"

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

void validate(const Scene& scene, Warnings& warnings) {
    requireValidCamera(scene);
    requireValidMaterials(scene);
    requireValidShapes(scene);
    requireRadianceInRange(scene);
    warnOfExcessEnergy(scene, warnings);
    warnOfLightPrecision(scene, warnings);
    warnOfCoplanarLights(scene, warnings);
    warnOfCameraPrecision(scene, warnings);
    warnOfTexturePrecision(scene, warnings);
    warnOfThinQuadrics(scene, warnings);
    warnOfSmallShapes(scene, warnings);
    warnOfWinding(scene, warnings);
    warnOfBlackPicture(scene, warnings);
}

} // namespace calotype
