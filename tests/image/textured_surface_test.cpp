// Textures, normal maps and alpha as they are seen.
#include <cmath>
#include <memory>
#include <numbers>

#include <glm/geometric.hpp>

#include "image/byte_image.h"
#include "support/gpu_test.h"
#include "support/image_means.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

class TexturedSurfaceTest : public GpuTest {};

// A white wall under light from everywhere shows its texture: row 0 of the image at the top.
TEST_F(TexturedSurfaceTest, TexelsAreSeenTheRightWayUp) {
    std::vector<uint8_t> bytes;
    for (uint8_t i = 0; i < 12; ++i)
        bytes.insert(bytes.end(),
                     {static_cast<uint8_t>(20 * i + 10), static_cast<uint8_t>(255 - 15 * i),
                      static_cast<uint8_t>(i % 2 == 0 ? 200 : 60), 255});
    SceneBuilder builder;
    ImageTexture source{bytesImage(4, 3, bytes)};
    source.filter = TextureFilter::Nearest;
    Material material;
    material.color = glm::dvec3(1.0);
    material.colorTexture = builder.texture({"numbers", source});
    builder.rectangle({-2.0, -1.5, 0.0}, {4.0, 0.0, 0.0}, {0.0, 3.0, 0.0},
                      builder.material(material));
    builder.lookAtPlaneZ(3.0);
    Scene& scene = builder.scene();
    scene.background = glm::dvec3(1.0);
    scene.film = {4, 3};
    scene.render = {4096, 1, 0};
    const Image image = renderScene(scene).image;
    for (uint32_t y = 0; y < 3; ++y)
        for (uint32_t x = 0; x < 4; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                const double wanted = decodedSrgb(bytes[4 * (4 * y + x) + channel] / 255.0);
                EXPECT_NEAR(image.at(x, y)[channel], wanted, 0.02 * wanted) << x << "," << y;
            }
}

/// A wall in the plane z = 0 whose normal map leans by `tilt` radians towards growing u, lit by a
/// small far light at `angle` radians from z towards x. The mean radiance seen.
double tiltedWall(double tilt, double angle, bool mirroredU, bool mapped = true) {
    SceneBuilder builder;
    Material material;
    material.color = glm::dvec3(0.5);
    if (mapped)
        material.normalMap =
            builder.constantTexture({0.5 + 0.5 * std::sin(tilt), 0.5, 0.5 + 0.5 * std::cos(tilt)});
    builder.rectangle({-0.01, -0.01, 0.0}, {0.02, 0.0, 0.0}, {0.0, 0.02, 0.0},
                      builder.material(material), mirroredU);
    const glm::dvec3 toLight(std::sin(angle), 0.0, std::cos(angle));
    const glm::dvec3 across(std::cos(angle), 0.0, -std::sin(angle));
    const uint32_t lamp = builder.material(0.0, 1000.0, true);
    builder.rectangle(10.0 * toLight + 0.05 * across - glm::dvec3(0.0, 0.05, 0.0), -0.1 * across,
                      {0.0, 0.1, 0.0}, lamp);
    builder.lookAtPlaneZ(0.01);
    Scene& scene = builder.scene();
    scene.render = {64, 1, 0};
    return imageMean(renderScene(scene).image).x;
}

// Lambert's cosine is that of the mapped normal, whichever way u runs.
TEST_F(TexturedSurfaceTest, ConstantTiltObeysLambertsCosine) {
    constexpr double kTilt = 0.5;
    // L dA / d^2 albedo / pi
    const double full = 1000.0 * 0.01 / 100.0 * 0.5 / std::numbers::pi;
    for (const double angle : {-0.9, -0.4, 0.0, 0.5, 1.2})
        for (const bool mirroredU : {false, true}) {
            const double tilt = mirroredU ? -kTilt : kTilt;
            const double wanted = full * std::max(0.0, std::cos(angle - tilt));
            EXPECT_NEAR(tiltedWall(kTilt, angle, mirroredU), wanted, 0.002 * full)
                << angle << (mirroredU ? " mirrored" : "");
        }
}

TEST_F(TexturedSurfaceTest, FlatNormalMapIsNone) {
    for (const double angle : {0.0, 0.7})
        EXPECT_NEAR(tiltedWall(0.0, angle, false), tiltedWall(0.0, angle, false, false), 1e-7);
}

/// A glowing wall behind a screen of the given alpha, half of the picture's height each: covered
/// above, free below.
Scene screenScene(double alpha, bool emits) {
    SceneBuilder builder;
    Material screen;
    screen.color = glm::dvec3(0.0);
    screen.emission = glm::dvec3(emits ? 2.0 : 0.0);
    const auto level = static_cast<uint8_t>(std::lround(alpha * 255.0));
    auto image = bytesImage(1, 1, {255, 255, 255, level});
    image->isTransparent = true;
    screen.alphaTexture = builder.texture({"screen", ImageTexture{image}});
    const uint32_t screenIndex = builder.material(screen);
    const uint32_t glow = builder.material(0.0, 1.0);
    builder.rectangle({-1.0, 0.0, 1.0}, {2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, screenIndex);
    builder.rectangle({-1.0, -1.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, glow);
    builder.lookAtPlaneZ(2.0);
    Scene& scene = builder.scene();
    scene.film = {32, 32};
    scene.render = {64, 0, 0};
    return scene;
}

double meanOfRows(const Image& image, uint32_t from, uint32_t to) {
    double sum = 0.0;
    for (uint32_t y = from; y < to; ++y)
        for (uint32_t x = 0; x < image.width; ++x)
            sum += image.at(x, y).x;
    return sum / ((to - from) * image.width);
}

// Alpha costs no bounce: with none allowed the wall is seen through the screen.
TEST_F(TexturedSurfaceTest, AlphaLetsTheCameraSeeThrough) {
    for (const double alpha : {0.0, 0.2, 0.6, 1.0}) {
        const Image image = renderScene(screenScene(alpha, false)).image;
        EXPECT_NEAR(meanOfRows(image, 0, 16), 1.0 - alpha, alpha * (1.0 - alpha) * 0.03 + 0.001);
        EXPECT_EQ(meanOfRows(image, 16, 32), 1.0);
        const Image glowing = renderScene(screenScene(alpha, true)).image;
        EXPECT_NEAR(meanOfRows(glowing, 0, 16), 1.0 + alpha, alpha * (1.0 - alpha) * 0.05 + 0.001);
    }
}

/// The light on a floor under a lamp, with a screen between or with a lamp of that alpha, found by
/// both strategies.
double litFloor(double screenAlpha, double lampAlpha, uint32_t screens) {
    SceneBuilder builder;
    const uint32_t floor = builder.material(0.8, 0.0);
    builder.rectangle({-2.0, -2.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, floor);
    Material screen;
    screen.opacity = screenAlpha;
    const uint32_t screenIndex = builder.material(screen);
    for (uint32_t i = 0; i < screens; ++i)
        builder.rectangle({-2.0, -2.0, 0.3 + 0.1 * i}, {4.0, 0.0, 0.0}, {0.0, 4.0, 0.0},
                          screenIndex);
    Material lamp;
    lamp.emission = glm::dvec3(3.0);
    lamp.opacity = lampAlpha;
    builder.rectangle({-1.0, -1.0, 1.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, builder.material(lamp));
    builder.lookAtPlaneZ(0.2);
    Scene& scene = builder.scene();
    scene.camera.position = {0.0, 0.0, 0.2}; // below screens and lamp
    scene.film = {32, 32};
    scene.render = {64, 1, 0};
    return imageMean(renderScene(scene).image).x;
}

TEST_F(TexturedSurfaceTest, ShadowsAreAsDeepAsAlphaSays) {
    const double open = litFloor(1.0, 1.0, 0);
    EXPECT_NEAR(litFloor(0.3, 1.0, 1) / open, 0.7, 0.01);
    EXPECT_NEAR(litFloor(0.3, 1.0, 2) / open, 0.49, 0.01);
    EXPECT_EQ(litFloor(1.0, 1.0, 1), 0.0);
    EXPECT_NEAR(litFloor(0.0, 1.0, 1) / open, 1.0, 0.01);
    EXPECT_NEAR(litFloor(1.0, 0.4, 0) / open, 0.4, 0.01);
}

/// The floor under a lamp of alpha 1/2 that is closed, so that its far side shines through.
double floorUnder(Shape lamp, double alpha, double emission) {
    SceneBuilder builder;
    const uint32_t floor = builder.material(0.8, 0.0);
    builder.rectangle({-2.0, -2.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, floor);
    Material glow;
    glow.emission = glm::dvec3(emission);
    glow.opacity = alpha;
    lamp.material = builder.material(glow);
    builder.add(std::move(lamp));
    builder.lookAtPlaneZ(0.2);
    Scene& scene = builder.scene();
    scene.camera.position = {0.0, 0.0, 0.2};
    scene.film = {32, 32};
    scene.render = {256, 1, 0};
    return imageMean(renderScene(scene).image).x;
}

// Every ray that meets a closed convex lamp meets it twice, so alpha a shines as a + (1 - a) a.
TEST_F(TexturedSurfaceTest, FarSideOfAClosedLampShinesThroughTheNearOne) {
    const RigidTransform above{glm::dmat3(1.0), {0.0, 0.0, 1.2}};
    for (const Shape& lamp :
         {makeShape(Sphere{above, 0.6}, 0), makeShape(Cylinder{above, 0.4, 0.9}, 0),
          makeShape(Cone{{glm::dmat3(1.0), {0.0, 0.4, 1.2}}, -0.9, 0.6}, 0)})
        EXPECT_NEAR(floorUnder(lamp, 0.5, 1.0) / floorUnder(lamp, 1.0, 1.0), 0.75, 0.015);
}

// A ray through a translucent ball reads alpha at its front and at its back.
TEST_F(TexturedSurfaceTest, TranslucentBallIsCrossedTwice) {
    SceneBuilder builder;
    Material veil;
    veil.opacity = 0.5;
    builder.add(makeShape(Sphere{{}, 1.0}, builder.material(veil)));
    builder.lookAtPlaneZ(0.5);
    Scene& scene = builder.scene();
    scene.background = glm::dvec3(1.0);
    scene.film = {32, 32};
    scene.render = {64, 0, 0};
    EXPECT_NEAR(imageMean(renderScene(scene).image).x, 0.25, 0.01);
}

} // namespace
} // namespace calotype::test
