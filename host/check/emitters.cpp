#include "check/emitters.h"

#include <cstddef>

#include "base/names.h"
#include "math/greatest.h"
#include "scene/place.h"
#include "scene/used_materials.h"

namespace calotype {

std::vector<Emitter> emittersOf(const Scene& scene) {
    std::vector<Emitter> emitters = {
        {greatest(scene.background), placeOf(scene, "/background"), ""}};
    const std::vector<bool> used = usedMaterials(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        if (used[i]) {
            emitters.push_back({greatest(scene.materials[i].emission), placeOfMaterial(scene, i),
                                "the material " + inQuotes(scene.materials[i].name) + " "});
        }
    }
    return emitters;
}

} // namespace calotype
