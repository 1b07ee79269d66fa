#include "scene/borne_materials.h"

namespace calotype {

std::vector<bool> borneMaterials(const Scene& scene) {
    std::vector<bool> borne(scene.materials.size());
    for (const Shape& shape : scene.shapes) {
        if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
            for (const Mesh::Triangle& triangle : mesh->triangles) {
                borne[triangle.material] = true;
            }
        } else {
            borne[shape.material] = true;
        }
    }
    return borne;
}

} // namespace calotype
