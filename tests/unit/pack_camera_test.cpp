// Cameras whose rays single precision does not hold are refused; all others give finite numbers.
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "pack/pack_camera.h"

namespace calotype::test {
namespace {

shared::Camera pack(const Camera& camera) { return packCamera(camera, FilmFilter::Box, {}, 2.0); }

void expectRefused(const Camera& camera, const char* fragment) {
    try {
        pack(camera);
        ADD_FAILURE() << "no SceneError was thrown";
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos) << error.what();
    }
}

Camera orthographic(double height) {
    Camera camera;
    camera.projection = Projection::Orthographic;
    camera.viewHeight = height;
    return camera;
}

Camera lens(double radius, double focus) {
    Camera camera;
    camera.lensRadius = radius;
    camera.focusDistance = focus;
    return camera;
}

TEST(PackCameraTest, RefusesWhatFloatDoesNotHold) {
    expectRefused(orthographic(1e13), "more than 1e12 metres");
    expectRefused(lens(1e13, 1e13), "more than 1e12 metres");
    expectRefused(lens(1.0, 1e-19), "lower lens_radius or fov");
    Camera wide;
    wide.verticalFov = std::nextafter(3.141592653589793, 0.0);
    EXPECT_TRUE(std::isfinite(pack(wide).right.x)); // a tangent of 1.6e16, twice as wide as high
}

TEST(PackCameraTest, HoldsAllOthers) {
    EXPECT_EQ(pack(orthographic(1e11)).up, glm::vec3(0.0f, 0.5e11f, 0.0f));
    EXPECT_EQ(pack(orthographic(1e-50)).up, glm::vec3(0.0f));
    EXPECT_EQ(pack(lens(1.0, 1e300)).focusDistance, 1e30f);
    EXPECT_EQ(pack(lens(0.0, 1e-300)).lensUp, glm::vec3(0.0f));
    EXPECT_EQ(pack(lens(1e-6, 1e6)).lensUp, glm::vec3(0.0f, 1e-6f, 0.0f));
}

} // namespace
} // namespace calotype::test
