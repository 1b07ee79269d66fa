#include "check/radiance_range.h"

#include <algorithm>

#include "base/error.h"
#include "base/names.h"
#include "scene/place.h"
#include "scene/used_materials.h"

namespace calotype {
namespace {

void requireInRange(const glm::dvec3& radiance, const std::string& where,
                    const std::string& subject) {
    constexpr double kFaintest = 1e-30;
    constexpr double kBrightest = 1e30;
    const double largest = std::max({radiance.x, radiance.y, radiance.z});
    if (largest > kBrightest || (largest > 0.0 && largest < kFaintest)) {
        throw SceneError(where, subject +
                                    "emits a radiance that is neither 0 nor from 1e-30 to 1e30 "
                                    "W/(m^2 sr); scale all lights alike, and the exposure back");
    }
}

} // namespace

void requireRadianceInRange(const Scene& scene) {
    requireInRange(scene.background, placeOf(scene, "/background"), "");
    const std::vector<bool> used = usedMaterials(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        if (used[i]) {
            requireInRange(scene.materials[i].emission, placeOfMaterial(scene, i),
                           "the material " + inQuotes(scene.materials[i].name) + " ");
        }
    }
}

} // namespace calotype
