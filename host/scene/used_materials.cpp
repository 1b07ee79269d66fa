#include "scene/used_materials.h"

namespace calotype {

std::vector<bool> usedMaterials(const Scene& scene) {
    std::vector<bool> used(scene.materials.size());
    for (const Shape& shape : scene.shapes) {
        if (const auto* mesh = std::get_if<Mesh>(&shape.geometry))
            for (const Mesh::Triangle& triangle : mesh->triangles)
                used[triangle.material] = true;
        else
            used[shape.material] = true;
    }
    return used;
}

} // namespace calotype
