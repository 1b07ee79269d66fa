#include "pack/scene_features.h"

namespace calotype {

const std::array<std::string_view, shared::kFeatureCount> kFeatureNames = {
    "triangles",
    "smooth normals",
    "spheres",
    "cylinders",
    "cones",
    "disks",
    "many quadrics",
    "triangle lights",
    "sphere lights",
    "cylinder lights",
    "cone lights",
    "disk lights",
    "hidden lights",
    "lights with alpha",
    "a background",
    "diffuse",
    "GGX",
    "mirrors",
    "Blinn-Phong",
    "dielectrics",
    "color textures",
    "roughness textures",
    "specular textures",
    "normal maps",
    "alpha",
    "8-bit images",
    "float images",
    "checkers",
    "a film filter",
    "a lens",
    "an orthographic camera",
};

SceneFeatures SceneFeatures::all() {
    SceneFeatures features;
    features.enabled.fill(true);
    return features;
}

} // namespace calotype
