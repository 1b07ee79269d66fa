#include "check/black_picture.h"

#include <cstddef>
#include <vector>

#include "scene/used_materials.h"

namespace calotype {
namespace {

bool hasEmission(const Scene& scene) {
    const std::vector<bool> used = usedMaterials(scene);
    for (size_t i = 0; i < used.size(); ++i)
        if (used[i] && scene.materials[i].emission != glm::dvec3(0.0))
            return true;
    return false;
}

} // namespace

void warnOfBlackPicture(const Scene& scene, Warnings& warnings) {
    if (scene.background != glm::dvec3(0.0))
        return;
    if (scene.shapes.empty()) {
        warnings.add(scene.place,
                     "there are no shapes and no lights, so the picture will be black");
    } else if (!hasEmission(scene)) {
        warnings.add(scene.place, "nothing emits light, so the picture will be black");
    }
}

} // namespace calotype
