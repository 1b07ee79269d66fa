#pragma once

#include <ostream>

namespace calotype::test {

/// Scenes of the project that together need every kind of primitive, material, texture, light and
/// camera: on them the device is judged by the reference tracer.
struct JudgedScene {
    const char* name;
    const char* path; ///< from the project's root
};

inline constexpr JudgedScene kJudgedScenes[] = {
    {"CornellBox", "scenes/cornell-box.json"},
    {"Everything", "tests/image/scenes/everything.json"},
    {"Surfaces", "tests/image/scenes/surfaces.json"},
    {"Metal", "scenes/metal.json"},
    {"Nonmetal", "scenes/nonmetal.json"},
    {"BlinnPhong", "scenes/blinn-phong.json"},
    {"Dielectric", "scenes/dielectric.json"},
    {"Texture", "scenes/texture.json"},
    {"Displacement", "scenes/displacement.json"},
    {"DepthOfField", "scenes/depth-of-field.json"},
    {"Orthographic", "scenes/orthographic.json"},
    {"Background", "scenes/background.json"},
    {"NormalCube", "scenes/normal-cube.json"},
    {"Sphere", "scenes/sphere.json"},
    {"Cylinder", "scenes/cylinder.json"},
    {"Cone", "scenes/cone.json"},
    {"Disk", "scenes/disk.json"},
    {"Mesh", "scenes/mesh.json"},
};

inline void PrintTo(const JudgedScene& scene, std::ostream* stream) { *stream << scene.name; }

} // namespace calotype::test
