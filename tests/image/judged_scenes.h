#pragma once

#include <ostream>

namespace calotype::test {

/// Scenes of the project that together need every kind of primitive, material, texture, light and
/// camera: on them the device is judged by the reference tracer.
struct JudgedScene {
    const char* name;
    const char* path; ///< from the project's root
    /// Share of the pixels that one sample may colour otherwise. Each event on a normal map or in
    /// glass multiplies what rounding did to a direction.
    double mostDiffering = 2e-4;
};

inline constexpr JudgedScene kJudgedScenes[] = {
    {"CornellBox", "scenes/cornell-box.json", 5e-4},
    {"Everything", "tests/image/scenes/everything.json"},
    {"Surfaces", "tests/image/scenes/surfaces.json", 5e-3},
    {"Metal", "scenes/metal.json"},
    {"Nonmetal", "scenes/nonmetal.json"},
    {"BlinnPhong", "scenes/blinn-phong.json"},
    {"Dielectric", "scenes/dielectric.json"},
    {"Texture", "scenes/texture.json", 1e-3},
    {"Displacement", "scenes/displacement.json", 1e-3},
    {"DepthOfField", "scenes/depth-of-field.json"},
    {"Orthographic", "scenes/orthographic.json"},
    {"Background", "scenes/background.json"},
    {"NormalCube", "scenes/normal-cube.json", 3e-3},
    {"Sphere", "scenes/sphere.json"},
    {"Cylinder", "scenes/cylinder.json"},
    {"Cone", "scenes/cone.json"},
    {"Disk", "scenes/disk.json"},
    {"Mesh", "scenes/mesh.json"},
    {"Lanterns", "tests/image/scenes/lanterns.json"},
    {"NearLamps", "tests/image/scenes/near-lamps.json"},
    {"Lamps", "tests/image/scenes/lamps.json"},
};

inline void PrintTo(const JudgedScene& scene, std::ostream* stream) { *stream << scene.name; }

} // namespace calotype::test
