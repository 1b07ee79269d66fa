#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pack/scene_features.h"
#include "scene/scene.h"
#include "settings/light_choice.h"
#include "shared/scene_structs.h"

namespace calotype {

/// Collects a scene's lights and their selection probabilities.
class LightPacker {
public:
    /// `scene` and `features` must outlive this object. Adds to `features` what the lights need.
    LightPacker(const Scene& scene, SceneFeatures& features,
                LightChoice choice = LightChoice::Power)
        : scene_(scene), features_(features), choice_(choice) {}

    /// Whether primitives of the material may be lights.
    bool isLight(uint32_t materialIndex) const;

    /// Adds the primitive with that name (shared::Light::primitive) and number in the scene file,
    /// if its material makes it a light. `kind` is that of shared::Light, `area` is in m^2. Throws
    /// SceneError if its radiance exceeds the range of single precision.
    void add(uint32_t kind, uint32_t materialIndex, uint32_t name, uint32_t number, double area);

    /// All lights with their alias table: first those of primitives, in the order of the scene
    /// file, then the background. So the choice by a random number does not depend on the BVH.
    /// Throws like `add`.
    std::vector<shared::Light> take();

    /// Largest emitted radiance of any channel, W/(m^2 sr).
    double maxRadiance() const { return maxRadiance_; }

private:
    struct NumberedLight {
        shared::Light light{};
        uint32_t number = 0; ///< of its primitive
        double power = 0.0;  ///< up to a common factor
    };

    void addBackground();

    const Scene& scene_;
    SceneFeatures& features_;
    LightChoice choice_;
    std::vector<NumberedLight> lights_;
    double maxRadiance_ = 0.0;
};

} // namespace calotype
