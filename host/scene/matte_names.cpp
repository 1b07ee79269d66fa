#include "scene/matte_names.h"

#include <unordered_map>
#include <variant>

#include "base/names.h"

namespace calotype {
namespace {

/// Numbers different names in the order in which they come. Names in files of materials may hold
/// bytes that are no UTF-8, which the manifest of a Cryptomatte must be.
class NameList {
public:
    uint32_t indexOf(const std::string& bytes) {
        const std::string name = asUtf8(bytes);
        const auto [found, isNew] =
            indices_.try_emplace(name, static_cast<uint32_t>(names_.size()));
        if (isNew)
            names_.push_back(name);
        return found->second;
    }

    std::vector<std::string> names() && { return std::move(names_); }

private:
    std::vector<std::string> names_;
    std::unordered_map<std::string, uint32_t> indices_;
};

std::string orDefault(const std::string& name, const char* kind, size_t index) {
    return name.empty() ? std::string(kind) + " " + std::to_string(index) : name;
}

} // namespace

MatteNames objectNames(const Scene& scene) {
    NameList list;
    std::vector<uint32_t> ofPrimitives;
    for (size_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        const Mesh* mesh = std::get_if<Mesh>(&shape.geometry);
        ofPrimitives.insert(ofPrimitives.end(), mesh ? mesh->triangles.size() : 1,
                            list.indexOf(orDefault(shape.name, "shape", i)));
    }
    return {std::move(list).names(), std::move(ofPrimitives)};
}

MatteNames materialNames(const Scene& scene) {
    NameList list;
    std::vector<uint32_t> ofMaterials;
    for (size_t i = 0; i < scene.materials.size(); ++i)
        ofMaterials.push_back(list.indexOf(orDefault(scene.materials[i].name, "material", i)));
    std::vector<uint32_t> ofPrimitives;
    for (const Shape& shape : scene.shapes)
        if (const Mesh* mesh = std::get_if<Mesh>(&shape.geometry))
            for (const Mesh::Triangle& triangle : mesh->triangles)
                ofPrimitives.push_back(ofMaterials[triangle.material]);
        else
            ofPrimitives.push_back(ofMaterials[shape.material]);
    return {std::move(list).names(), std::move(ofPrimitives)};
}

} // namespace calotype
