#include "extremes/scaled_scene.h"

#include "extremes/closed_meshes.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

void scale(Sphere& sphere, double factor) { sphere.radius *= factor; }

void scale(Cylinder& cylinder, double factor) {
    cylinder.radius *= factor;
    cylinder.height *= factor;
}

void scale(Cone& cone, double factor) { cone.height *= factor; }

void scale(Disk& disk, double factor) { disk.radius *= factor; }

template <typename Quadric>
void scaleAndMove(Quadric& quadric, double factor, const glm::dvec3& offset) {
    scale(quadric, factor);
    glm::dvec3& place = quadric.worldFromObject.translation;
    place = factor * place + offset;
}

void scaleAndMove(Mesh& mesh, double factor, const glm::dvec3& offset) {
    for (glm::dvec3& position : mesh.positions)
        position = factor * position + offset;
}

} // namespace

Scene scaledAndMoved(Scene scene, double factor, const glm::dvec3& offset) {
    for (Shape& shape : scene.shapes)
        std::visit([&](auto& geometry) { scaleAndMove(geometry, factor, offset); }, shape.geometry);
    scene.camera.position = factor * scene.camera.position + offset;
    scene.camera.viewHeight *= factor;
    scene.camera.lensRadius *= factor;
    scene.camera.focusDistance *= factor;
    return scene;
}

Scene everyShape() {
    Scene scene = projectScene("tests/image/scenes/everything.json");
    Material glass;
    glass.name = "glass";
    glass.type = MaterialType::Dielectric;
    glass.color = glm::dvec3(1.0);
    scene.materials.push_back(glass);
    const auto index = static_cast<uint32_t>(scene.materials.size() - 1);
    scene.shapes.push_back(makeShape(Sphere{{glm::dmat3(1.0), {1.0, 0.36, 1.2}}, 0.35}, index));
    Mesh cube = moved(stretched(turned(cubeMesh(2)), glm::dvec3(0.15)), {-1.0, 0.4, 1.6});
    for (Mesh::Triangle& triangle : cube.triangles)
        triangle.material = index;
    scene.shapes.push_back(shapeOf(std::move(cube)));
    scene.background = glm::dvec3(0.05, 0.06, 0.08);
    scene.camera.lensRadius = 0.03;
    scene.camera.focusDistance = 4.5;
    return scene;
}

} // namespace calotype::test
