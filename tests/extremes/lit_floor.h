#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "support/scene_builder.h"

namespace calotype::test {

inline constexpr double kFloorAlbedo = 0.5;

/// A diffuse floor in the plane y = 0, from -half to half.
inline void addFloor(SceneBuilder& builder, double half) {
    builder.polygon({{-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}},
                    builder.material(kFloorAlbedo, 0.0));
    builder.scene().render.maxBounces = 1;
}

/// Parallel rays straight down from `height` onto the square of `side` metres about (x, 0, z).
inline void lookDownAt(SceneBuilder& builder, double x, double z, double height, double side) {
    Camera& camera = builder.scene().camera;
    camera = {};
    camera.projection = Projection::Orthographic;
    camera.position = {x, height, z};
    camera.forward = {0.0, -1.0, 0.0};
    camera.up = {0.0, 0.0, -1.0};
    camera.viewHeight = side;
}

/// The radiance of the floor where it receives `irradiance`.
inline double floorRadiance(double irradiance) {
    return kFloorAlbedo * irradiance / std::numbers::pi;
}

} // namespace calotype::test
