#include "check/light_precision.h"

#include <algorithm>

#include "base/names.h"
#include "scene/place.h"
#include "scene/used_materials.h"

namespace calotype {
namespace {

/// Relative to the brightest light. A film rounds sums of 16 samples to 2^-64 of a unit, up to
/// twice that light. So a picture of a light this faint alone has an error of up to 2^-14.
constexpr double kFaintest = 0x1p-54;

double brightestChannel(const glm::dvec3& radiance) {
    return std::max({radiance.x, radiance.y, radiance.z});
}

} // namespace

void warnOfLightPrecision(const Scene& scene, Warnings& warnings) {
    const std::vector<bool> used = usedMaterials(scene);
    double brightest = brightestChannel(scene.background);
    for (size_t i = 0; i < used.size(); ++i)
        if (used[i])
            brightest = std::max(brightest, brightestChannel(scene.materials[i].emission));
    const auto warnIfFaint = [&](const glm::dvec3& radiance, const std::string& where,
                                 const std::string& subject) {
        const double channel = brightestChannel(radiance);
        if (channel > 0.0 && channel < kFaintest * brightest) {
            warnings.add(where, subject +
                                    "shines with less than 5e-17 of the radiance of the brightest "
                                    "light, beside which the film loses it; render the two in "
                                    "pictures of their own and add these");
        }
    };
    warnIfFaint(scene.background, placeOf(scene, "/background"), "");
    for (size_t i = 0; i < used.size(); ++i) {
        if (used[i]) {
            warnIfFaint(scene.materials[i].emission, placeOfMaterial(scene, i),
                        "the material " + inQuotes(scene.materials[i].name) + " ");
        }
    }
}

} // namespace calotype
