#include "scene/place.h"

#include "base/names.h"

namespace calotype {

std::string placeOf(const Scene& scene, const std::string& pointer) {
    return scene.place + ": " + pointer;
}

std::string placeOfShape(const Scene& scene, size_t index) {
    const std::string& place = scene.shapes[index].place;
    return place.empty() ? placeOf(scene, "/shapes/" + std::to_string(index)) : place;
}

std::string placeOf(const Scene& scene, const Shape& shape) {
    return placeOfShape(scene, static_cast<size_t>(&shape - scene.shapes.data()));
}

std::string placeOfMaterial(const Scene& scene, size_t index) {
    const Material& material = scene.materials[index];
    return material.place.empty() ? placeOf(scene, "material " + inQuotes(material.name))
                                  : material.place;
}

} // namespace calotype
