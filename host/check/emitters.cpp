#include "check/emitters.h"

#include <algorithm>
#include <cstddef>

#include "base/names.h"
#include "scene/place.h"
#include "scene/used_materials.h"

namespace calotype {
namespace {

double brightestChannel(const glm::dvec3& radiance) {
    return std::max({radiance.x, radiance.y, radiance.z});
}

} // namespace

std::vector<Emitter> emittersOf(const Scene& scene) {
    std::vector<Emitter> emitters = {
        {brightestChannel(scene.background), placeOf(scene, "/background"), ""}};
    const std::vector<bool> used = usedMaterials(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        if (used[i]) {
            emitters.push_back({brightestChannel(scene.materials[i].emission),
                                placeOfMaterial(scene, i),
                                "the material " + inQuotes(scene.materials[i].name) + " "});
        }
    }
    return emitters;
}

} // namespace calotype
