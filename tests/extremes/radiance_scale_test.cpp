// Radiance from 1e-30 to 1e30: the picture scales with it, to the last bit where the factor is a
// power of two, through the film and every kind of file.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "extremes/lit_floor.h"
#include "film/display_transform.h"
#include "image/exr.h"
#include "image/pfm.h"
#include "image/read_image.h"
#include "support/gpu_test.h"
#include "support/image_means.h"
#include "support/render_scene.h"
#include "support/scratch_folder.h"

namespace calotype::test {
namespace {

using RadianceScaleTest = GpuTest;

/// Every kind of primitive, light and material, all light multiplied by a factor.
Scene litBy(double factor) {
    Scene scene = projectScene("tests/image/scenes/everything.json");
    scene.background *= factor;
    for (Material& material : scene.materials)
        material.emission *= factor;
    return scene;
}

RenderedScene render(const Scene& scene) {
    RenderWish wish;
    wish.width = 48;
    wish.height = 40;
    wish.samplesPerPixel = 40; // two blocks and a part of one
    RenderedScene result = renderScene(scene, wish);
    EXPECT_EQ(result.totals.losses.nonFiniteSamples + result.totals.losses.cutPaths, 0u);
    EXPECT_EQ(result.totals.losses.lostPixels(), 0u);
    return result;
}

TEST_F(RadianceScaleTest, PowersOfTwoScaleEveryBit) {
    const Image plain = render(litBy(1.0)).image;
    for (const double factor : {0x1p-96, 0x1p-50, 0x1p50, 0x1p94}) {
        SCOPED_TRACE(factor);
        const Image scaled = render(litBy(factor)).image;
        size_t different = 0;
        for (size_t i = 0; i < plain.pixels.size(); ++i)
            different += glm::dvec3(scaled.pixels[i]) != factor * glm::dvec3(plain.pixels[i]);
        EXPECT_EQ(different, 0u);
    }
    EXPECT_GT(imageMean(plain).x, 0.01);
}

// Other factors round the lamps' radiance, by 2^-24 of itself, and every sum after it.
TEST_F(RadianceScaleTest, BothEndsOfTheRange) {
    const Image plain = render(litBy(1.0)).image;
    for (const double factor : {1e-30, 1.6e29}) { // its lights are of 1 to 6
        SCOPED_TRACE(factor);
        const Image scaled = render(litBy(factor)).image;
        double worst = 0.0;
        for (size_t i = 0; i < plain.pixels.size(); ++i)
            for (int channel = 0; channel < 3; ++channel) {
                const double expected = factor * plain.pixels[i][channel];
                const double difference = std::abs(scaled.pixels[i][channel] - expected);
                worst = std::max(worst, expected > 0.0 ? difference / expected : difference);
            }
        EXPECT_LT(worst, 1e-5);
        std::cout << "factor " << factor << ": worst relative difference " << worst << "\n";
    }
}

TEST_F(RadianceScaleTest, FilesHoldBothEnds) {
    const ScratchFolder folder;
    for (const double factor : {0x1p-96, 0x1p94}) {
        const Image image = render(litBy(factor)).image;
        for (const char* name : {"image.pfm", "image.exr"}) {
            const auto path = folder / name;
            if (path.extension() == ".pfm")
                writePfm(path, image);
            else
                writeExr(path, {image});
            EXPECT_EQ(readImage(path).pixels, image.pixels) << path << " " << factor;
        }
        for (const ToneMap toneMap : {ToneMap::None, ToneMap::Neutral, ToneMap::Reinhard}) {
            DisplayTransform transform;
            transform.toneMap = toneMap;
            const Rgb8Image shown = toDisplay(image, transform);
            for (size_t i = 0; i < image.pixels.size(); ++i) {
                const glm::vec3& pixel = image.pixels[i];
                const bool isBright = factor > 1.0 && std::max({pixel.x, pixel.y, pixel.z}) > 0.0f;
                const glm::u8vec3& rgb = shown.pixels[i];
                EXPECT_EQ(std::max({rgb.r, rgb.g, rgb.b}), isBright ? 255 : 0);
            }
        }
    }
}

// A lamp of a millionth of a square metre, 1e12 times brighter than the background: the background
// is kept to the last bit beside it, and the floor receives what both send.
TEST_F(RadianceScaleTest, TinyLampBesideADimBackground) {
    const double r = std::sqrt(1e-6 / (4.0 * std::numbers::pi));
    SceneBuilder builder;
    builder.add(
        makeShape(Sphere{{glm::dmat3(1.0), {0.0, 1.0, 0.0}}, r}, builder.material(0, 1e12)));
    addFloor(builder, 5.0);
    Scene& scene = builder.scene();
    scene.background = glm::dvec3(1.0);
    scene.film = {32, 32};
    scene.render = {64, 1, 3};
    lookDownAt(builder, 0.3, 0.0, 0.5, 1e-3);
    const RenderedScene lit = renderScene(scene);
    const double d2 = 1.0 + 0.3 * 0.3;
    const double fromLamp = floorRadiance(std::numbers::pi * 1e12 * r * r / std::pow(d2, 1.5));
    EXPECT_NEAR(imageMean(lit.image).x, fromLamp + kFloorAlbedo, 1e-3 * fromLamp);
    EXPECT_EQ(lit.totals.losses.nonFiniteSamples + lit.totals.losses.lostPixels(), 0u);

    scene.camera.forward = {0.0, 1.0, 0.0};
    scene.camera.right = {-1.0, 0.0, 0.0};
    for (const glm::vec3& pixel : renderScene(scene).image.pixels)
        EXPECT_EQ(pixel, glm::vec3(1.0f));
}

} // namespace
} // namespace calotype::test
