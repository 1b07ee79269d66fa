// Colours, normals and what is seen through, at the surfaces that pixels show first.
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "image/byte_image.h"
#include "support/first_hits.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

/// Of a few operations on numbers about 1 in single precision: 16 roundings of 2^-23.
constexpr double kRounding = 16.0 / (1 << 23);

/// A square of 2 x 2 metres about the origin in the plane z = `z`.
SceneBuilder& addSquare(SceneBuilder& builder, double z, uint32_t material,
                        bool mirroredU = false) {
    return builder.rectangle({-1.0, -1.0, z}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, material,
                             mirroredU);
}

/// What the 2 x 2 pixels over the squares about the origin show.
FirstHits seen(SceneBuilder& builder) {
    builder.lookAtPlaneZ(2.0).scene().film = {2, 2};
    return firstHitsOf(builder.scene());
}

class FirstHitMaterialTest : public GpuTest {};

TEST_F(FirstHitMaterialTest, AlbedoIsTheMaterialsColour) {
    const glm::dvec3 color(0.25, 0.5, 0.75);
    for (const MaterialType type :
         {MaterialType::Diffuse, MaterialType::Metal, MaterialType::Nonmetal,
          MaterialType::BlinnPhong, MaterialType::Dielectric})
        for (const double emission : {0.0, 7.0}) {
            SceneBuilder builder;
            Material material;
            material.type = type;
            material.color = color;
            material.kd = 0.3;
            material.ks = 0.2;
            material.emission = glm::dvec3(emission);
            addSquare(builder, 0.0, builder.material(material));
            const bool isGlass = type == MaterialType::Dielectric;
            for (const FirstHit& hit : seen(builder).image.pixels)
                EXPECT_EQ(hit.albedo, glm::vec3(isGlass ? glm::dvec3(1.0) : color))
                    << "type " << static_cast<int>(type);
        }
}

// Row 0 of the image at the top, decoded, times the colour.
TEST_F(FirstHitMaterialTest, AlbedoLooksItsTextureUp) {
    SceneBuilder builder;
    ImageTexture source{bytesImage(2, 2,
                                   {250, 200, 150, 255, 10, 40, 90, 255, //
                                    30, 60, 120, 255, 220, 5, 77, 255})};
    source.filter = TextureFilter::Nearest;
    Material material;
    material.color = {1.0, 0.5, 0.25};
    material.colorTexture = builder.texture({"four", source});
    addSquare(builder, 0.0, builder.material(material));
    const FirstHitImage image = seen(builder).image;
    const auto& bytes = source.image->bytes;
    for (uint32_t y = 0; y < 2; ++y)
        for (uint32_t x = 0; x < 2; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                const double texel = decodedSrgb(bytes[4 * (2 * y + x) + channel] / 255.0);
                EXPECT_NEAR(image.at(x, y).albedo[channel], material.color[channel] * texel,
                            kRounding); // srgb.glsl states 1.2e-6 of the value
            }
}

/// The normal of a square whose normal map leans by `tilt` radians towards growing u.
glm::vec3 tiltedNormal(double tilt, bool mirroredU, bool fromBehind) {
    SceneBuilder builder;
    Material material;
    material.color = glm::dvec3(0.5);
    material.normalMap =
        builder.constantTexture({0.5 + 0.5 * std::sin(tilt), 0.5, 0.5 + 0.5 * std::cos(tilt)});
    addSquare(builder, 0.0, builder.material(material), mirroredU);
    builder.lookAtPlaneZ(2.0).scene().film = {1, 1};
    Camera& camera = builder.scene().camera;
    if (fromBehind) {
        camera.position.z = -camera.position.z;
        camera.forward = -camera.forward;
        camera.right = -camera.right;
    }
    return firstHitsOf(builder.scene()).image.pixels[0].normal;
}

// Out of the true surface's front the map leans; a viewer behind it sees the opposite.
TEST_F(FirstHitMaterialTest, NormalIsTheMapsOnTheViewersSide) {
    for (const double tilt : {0.0, 0.5, 1.2})
        for (const bool mirroredU : {false, true})
            for (const bool fromBehind : {false, true}) {
                const double side = fromBehind ? -1.0 : 1.0;
                const glm::dvec3 wanted =
                    side * glm::dvec3(std::sin(mirroredU ? -tilt : tilt), 0.0, std::cos(tilt));
                const glm::vec3 normal = tiltedNormal(tilt, mirroredU, fromBehind);
                EXPECT_LT(glm::distance(glm::dvec3(normal), wanted), kRounding) << tilt;
            }
}

TEST_F(FirstHitMaterialTest, NormalIsInterpolated) {
    SceneBuilder builder;
    Mesh mesh;
    mesh.positions = {{-3.0, -3.0, 0.0}, {3.0, -3.0, 0.0}, {0.0, 6.0, 0.0}}; // middle: the origin
    mesh.normals = {glm::normalize(glm::dvec3(-1, -1, 2)), glm::normalize(glm::dvec3(2, -1, 3)),
                    glm::normalize(glm::dvec3(0, 1, 1))};
    mesh.triangles = {{{0, 1, 2}, {0, 1, 2}, builder.material(0.5, 0.0)}};
    const glm::dvec3 wanted = glm::normalize(mesh.normals[0] + mesh.normals[1] + mesh.normals[2]);
    builder.add(makeShape(mesh, 0)).lookAtPlaneZ(1.0).scene().film = {1, 1};
    const FirstHit hit = firstHitsOf(builder.scene()).image.pixels[0];
    EXPECT_LT(glm::distance(glm::dvec3(hit.normal), wanted), kRounding);
}

/// A square before another: the number of the primitive that the picture's top left pixel shows,
/// as a square's, so 0 or 1; through an image of one texel with that alpha, and that opacity.
uint32_t shownBehindScreen(uint8_t alpha, double opacity) {
    SceneBuilder builder;
    Material screen;
    screen.opacity = opacity;
    screen.alphaTexture =
        builder.texture({"screen", ImageTexture{bytesImage(1, 1, {255, 255, 255, alpha})}});
    addSquare(builder, 1.0, builder.material(screen));
    addSquare(builder, 0.0, builder.material(0.5, 0.0));
    return seen(builder).image.pixels[0].primitive / 2;
}

TEST_F(FirstHitMaterialTest, AlphaBelowOneHalfIsSeenThrough) {
    EXPECT_EQ(shownBehindScreen(255, 1.0), 0u);
    EXPECT_EQ(shownBehindScreen(128, 1.0), 0u);
    EXPECT_EQ(shownBehindScreen(127, 1.0), 1u);
    EXPECT_EQ(shownBehindScreen(0, 1.0), 1u);
    EXPECT_EQ(shownBehindScreen(255, 0.5), 0u);
    EXPECT_EQ(shownBehindScreen(255, 0.499), 1u);
    EXPECT_EQ(shownBehindScreen(170, 0.7), 1u);
}

// Its hole shows what is behind, or nothing; its rim shows itself.
TEST_F(FirstHitMaterialTest, CutOutIsSeenWhereItIsAndThroughWhereItIsNot) {
    SceneBuilder builder;
    ImageTexture source{bytesImage(2, 2,
                                   {0, 0, 0, 255, 0, 0, 0, 0, //
                                    0, 0, 0, 0, 0, 0, 0, 255})};
    source.filter = TextureFilter::Nearest;
    Material leaf;
    leaf.alphaTexture = builder.texture({"leaf", source});
    addSquare(builder, 0.0, builder.material(leaf));
    const FirstHitImage image = seen(builder).image;
    EXPECT_NE(image.at(0, 0).primitive, kNoPrimitive);
    EXPECT_EQ(image.at(1, 0).primitive, kNoPrimitive);
    EXPECT_EQ(image.at(0, 1).primitive, kNoPrimitive);
    EXPECT_NE(image.at(1, 1).primitive, kNoPrimitive);
}

TEST_F(FirstHitMaterialTest, HiddenLightsAreSeenThroughFromBothSides) {
    for (const bool visible : {true, false})
        for (const bool frontOnly : {true, false}) {
            SceneBuilder builder;
            Material lamp;
            lamp.emission = glm::dvec3(5.0);
            lamp.visibleToCamera = visible;
            lamp.emitsFromFrontOnly = frontOnly;
            const uint32_t lampIndex = builder.material(lamp);
            addSquare(builder, 2.0, lampIndex);
            builder.add(makeShape(Sphere{{glm::dmat3(1.0), {0.0, 0.0, 1.0}}, 0.9}, lampIndex));
            addSquare(builder, 0.0, builder.material(0.5, 0.0));
            const FirstHits hits = seen(builder);
            EXPECT_EQ(hits.image.pixels[0].primitive, visible ? 1u : 4u);
            EXPECT_EQ(hits.image.pixels[0].albedo, glm::vec3(visible ? 0.0f : 0.5f));
            EXPECT_EQ(hits.cutPixels, 0u);
        }
}

/// A wall behind a stack of clear squares.
FirstHits behindStack(uint32_t count) {
    SceneBuilder builder;
    Material clear;
    clear.opacity = 0.0;
    const uint32_t clearIndex = builder.material(clear);
    addSquare(builder, 0.0, builder.material(0.5, 0.0));
    for (uint32_t i = 1; i <= count; ++i)
        addSquare(builder, 4.0 * i / count, clearIndex);
    return seen(builder);
}

TEST_F(FirstHitMaterialTest, DeepStacksAreCutAndCounted) {
    const FirstHits shallow = behindStack(60);
    EXPECT_EQ(shallow.cutPixels, 0u);
    for (const FirstHit& hit : shallow.image.pixels)
        EXPECT_LT(hit.primitive, 2u);
    const FirstHits deep = behindStack(1100);
    EXPECT_EQ(deep.cutPixels, 4u);
    for (const FirstHit& hit : deep.image.pixels) {
        EXPECT_NE(hit.primitive, kNoPrimitive);
        EXPECT_GE(hit.primitive, 2u);
    }
}

} // namespace
} // namespace calotype::test
