#include <bit>
#include <memory>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "pack/pack_shapes.h"
#include "support/random_numbers.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Grey, a lamp of both sides, a hidden one-sided lamp.
std::vector<Material> materials() {
    Material grey;
    grey.color = glm::dvec3(0.25, 0.5, 0.75);
    Material lamp;
    lamp.emission = glm::dvec3(1.0, 2.0, 4.0);
    Material hidden;
    hidden.emission = glm::dvec3(8.0, 0.0, 0.0);
    hidden.emitsFromFrontOnly = true;
    hidden.visibleToCamera = false;
    return {grey, lamp, hidden};
}

GpuScene packed(std::vector<Shape> shapes) {
    Scene scene = sceneOf(std::move(shapes));
    scene.materials = materials();
    return packAsProgram(scene).packed;
}

std::set<uint32_t> featuresOf(const GpuScene& scene) {
    std::set<uint32_t> enabled;
    for (uint32_t i = 0; i < shared::kFeatureCount; ++i)
        if (scene.features.enabled[i])
            enabled.insert(i);
    return enabled;
}

Mesh triangleOf(uint32_t material) {
    Mesh mesh = singleTriangle({0, 0, 0}, {2, 0, 0}, {0, 1, 0});
    mesh.triangles[0].material = material;
    return mesh;
}

using Features = std::set<uint32_t>;

TEST(PackSceneTest, EnablesWhatTheSceneHasAndNothingElse) {
    constexpr uint32_t kDiffuse = shared::kFeatureDiffuse; // of material 0; lamps are black
    EXPECT_EQ(featuresOf(packed({shapeOf(Sphere{})})),
              (Features{shared::kFeatureSpheres, kDiffuse}));
    EXPECT_EQ(featuresOf(packed({shapeOf(Cylinder{})})),
              (Features{shared::kFeatureCylinders, kDiffuse}));
    EXPECT_EQ(featuresOf(packed({shapeOf(Cone{})})), (Features{shared::kFeatureCones, kDiffuse}));
    EXPECT_EQ(featuresOf(packed({shapeOf(Disk{})})), (Features{shared::kFeatureDisks, kDiffuse}));
    EXPECT_EQ(featuresOf(packed({shapeOf(triangleOf(0))})),
              (Features{shared::kFeatureTriangles, kDiffuse}));
    EXPECT_EQ(featuresOf(packed({shapeOf(triangleOf(1))})),
              (Features{shared::kFeatureTriangles, shared::kFeatureTriangleLights,
                        shared::kFeatureSolidAngleLights}));
    EXPECT_EQ(
        featuresOf(packed({shapeOf(Sphere{}, 1), shapeOf(Disk{}, 2)})),
        (Features{shared::kFeatureSpheres, shared::kFeatureDisks, shared::kFeatureSphereLights,
                  shared::kFeatureDiskLights, shared::kFeatureHiddenLights}));
    EXPECT_EQ(featuresOf(packed({shapeOf(Cylinder{}, 1), shapeOf(Cone{}, 1)})),
              (Features{shared::kFeatureCylinders, shared::kFeatureCones,
                        shared::kFeatureCylinderLights, shared::kFeatureConeLights}));
    Mesh smooth = triangleOf(0);
    smooth.normals = {{0, 0, 1}};
    smooth.triangles[0].normal[0] = smooth.triangles[0].normal[1] = smooth.triangles[0].normal[2] =
        0;
    EXPECT_EQ(featuresOf(packed({shapeOf(smooth)})),
              (Features{shared::kFeatureTriangles, shared::kFeatureSmoothNormals, kDiffuse}));
}

// From 65 equal lights on, each is chosen in less than one of 64 cases.
TEST(PackSceneTest, SamplesTrianglesBySolidAngleIfTheyAreOftenChosen) {
    for (const size_t count : {64, 65}) {
        const GpuScene scene = packed(std::vector<Shape>(count, shapeOf(triangleOf(1))));
        ASSERT_EQ(scene.lightCount, count);
        for (const shared::Light& light : scene.lights)
            EXPECT_EQ((light.flags & shared::kLightBySolidAngle) != 0, count == 64);
        EXPECT_EQ(scene.features.enabled[shared::kFeatureSolidAngleLights], count == 64);
    }
}

// From a quarter of what rays visit on, quadrics are many; where they are alone, it does not
// matter.
TEST(PackSceneTest, SeparatesFewQuadricsFromMany) {
    const auto areMany = [](std::vector<Shape> shapes) {
        return packed(std::move(shapes)).features.enabled[shared::kFeatureManyQuadrics];
    };
    // Boxes of 2 x 1 x 0 m about the triangle and a cube about the ball: half areas 2 and 3 d^2.
    const auto ball = [](double diameter) {
        return shapeOf(Sphere{{glm::dmat3(1.0), {1.0, 0.5, 0.0}}, 0.5 * diameter});
    };
    EXPECT_FALSE(areMany({shapeOf(triangleOf(0)), ball(0.45)}));
    EXPECT_TRUE(areMany({shapeOf(triangleOf(0)), ball(0.5)}));
    EXPECT_FALSE(areMany({shapeOf(triangleOf(0))}));
    EXPECT_FALSE(areMany({ball(0.5)}));
}

// What only an unused material needs is neither compiled in nor uploaded.
TEST(PackSceneTest, LeavesOutMaterialsThatNoShapeUses) {
    Scene scene = sceneOf({shapeOf(Sphere{})});
    auto image = std::make_shared<TexelImage>();
    image->width = image->height = 64;
    image->bytes.resize(4 * 64 * 64);
    scene.textures = {{"unused", ImageTexture{image}}};
    scene.materials.resize(2);
    scene.materials[1].type = MaterialType::Metal;
    scene.materials[1].colorTexture = 0;
    EXPECT_EQ(featuresOf(packAsProgram(scene).packed),
              (Features{shared::kFeatureSpheres, shared::kFeatureDiffuse}));
    EXPECT_LT(rowCount(packAsProgram(scene).packed.texelRows), 2u);
    scene.shapes[0].material = 1;
    EXPECT_EQ(featuresOf(packAsProgram(scene).packed),
              (Features{shared::kFeatureSpheres, shared::kFeatureGgx, shared::kFeatureMirrors,
                        shared::kFeatureColorTextures, shared::kFeatureByteTexels}));
    EXPECT_EQ(rowCount(packAsProgram(scene).packed.texelRows), 64u * 64u / 4u);
}

// One image, read in two ways: colours weighted by alpha, and alpha itself.
TEST(PackSceneTest, PacksColoursOfCutOutsBesideTheirAlpha) {
    Scene scene = sceneOf({shapeOf(Sphere{})});
    auto image = std::make_shared<TexelImage>();
    image->width = image->height = 2;
    image->bytes.resize(4 * 2 * 2);
    image->isTransparent = true;
    scene.textures = {{"leaf", ImageTexture{image}}};
    scene.materials.resize(1);
    scene.materials[0].colorTexture = 0;
    const auto hasFeature = [](const GpuScene& packed) {
        return packed.features.enabled[shared::kFeatureCutOutColors];
    };
    EXPECT_FALSE(hasFeature(packAsProgram(scene).packed));
    scene.materials[0].alphaTexture = 0;
    const GpuScene packed = packAsProgram(scene).packed;
    EXPECT_TRUE(hasFeature(packed));
    const auto isCutOut = [&](uint32_t texture) {
        return (packed.textures.at(texture).flags & shared::kTextureIsCutOut) != 0;
    };
    EXPECT_TRUE(isCutOut(packed.materials[0].colorTexture));
    EXPECT_FALSE(isCutOut(packed.materials[0].alphaTexture));
    EXPECT_EQ(rowCount(packed.texelRows), 1u);
}

// Half of the light samples at most go to the background, which rays that leave find anyway.
TEST(PackSceneTest, BackgroundIsALightOfItsOwnKind) {
    Scene scene = sceneOf({shapeOf(Sphere{}, 1), shapeOf(Disk{{}, 1e4})});
    scene.materials = materials();
    scene.background = glm::dvec3(0.5, 16.0, 1.0);
    const GpuScene packed = packAsProgram(scene).packed;
    ASSERT_EQ(packed.lightCount, 2u);
    ASSERT_LT(packed.infiniteLight, packed.lightCount);
    const shared::Light& background = packed.lights[packed.infiniteLight];
    EXPECT_EQ(background.kind, shared::kLightBackground);
    EXPECT_EQ(background.primitive, shared::kNone);
    EXPECT_EQ(background.radiance, glm::vec3(0.5f, 16.0f, 1.0f));
    EXPECT_NEAR(background.selectionProbability, 0.5, 1e-6);
    EXPECT_EQ(packed.maxRadiance, 16.0);
}

TEST(PackSceneTest, LinksLightsAndPrimitivesBothWays) {
    const GpuScene scene = packed({shapeOf(Sphere{{}, 2.0}, 1), shapeOf(Sphere{{}, 1.0}),
                                   shapeOf(triangleOf(2)), shapeOf(Disk{{}, 3.0}, 1)});
    ASSERT_EQ(scene.lightCount, 3u);
    double chances = 0.0;
    for (uint32_t i = 0; i < scene.lightCount; ++i) {
        const shared::Light& light = scene.lights[i];
        chances += double(light.selectionProbability);
        const bool isQuadric = light.primitive & shared::kQuadricBit;
        const uint32_t index = light.primitive & ~shared::kQuadricBit;
        EXPECT_EQ(isQuadric ? scene.quadrics[index].light : scene.triangles[index].light, i);
        EXPECT_EQ(light.kind, isQuadric ? shared::kLightSphere + scene.quadrics[index].kind
                                        : shared::kLightTriangle);
        const uint32_t id = isQuadric ? scene.quadrics[index].id : scene.triangles[index].id;
        // By luminance, area and sides, up to a common factor.
        const double lamp = 2.0 * (0.2126 + 2.0 * 0.7152 + 4.0 * 0.0722);
        const std::array powers = {lamp * 16.0 * kPi, 0.0, 0.2126 * 8.0 * 1.0, lamp * 9.0 * kPi};
        const double sum = powers[0] + powers[2] + powers[3];
        EXPECT_NEAR(light.selectionProbability, powers[id] / sum, 1e-6);
        const std::array areas = {16.0 * kPi, 0.0, 1.0, 9.0 * kPi};
        EXPECT_NEAR(light.area, areas[id], 1e-5);
        EXPECT_EQ(light.radiance, id == 2 ? glm::vec3(8, 0, 0) : glm::vec3(1, 2, 4));
        EXPECT_EQ(light.flags,
                  id == 2 ? shared::kLightHiddenFromCamera : shared::kLightEmitsFromBack);
    }
    EXPECT_NEAR(chances, 1.0, 1e-6);
    EXPECT_EQ(scene.maxRadiance, 8.0);
    for (const shared::Quadric& quadric : scene.quadrics)
        EXPECT_EQ(quadric.light == shared::kNone, quadric.id == 1);
}

TEST(PackSceneTest, ItsNodesShareOutThePrimitives) {
    std::vector<Shape> shapes;
    for (int i = 0; i < 100; ++i) {
        shapes.push_back(shapeOf(Sphere{{glm::dmat3(1.0), {double(i), 0.0, 0.0}}, 0.4}));
        shapes.push_back(
            shapeOf(singleTriangle({double(i), 0, 0}, {i + 0.5, 1, 0}, {i + 0.5, 0, 1})));
    }
    const GpuScene scene = packed(shapes);
    std::vector<uint32_t> triangleLeaves(scene.triangles.size());
    std::vector<uint32_t> quadricLeaves(scene.quadrics.size());
    std::vector<uint32_t> places = {0};
    for (size_t i = 0; i < places.size(); ++i) {
        const shared::BvhNode& node = scene.nodes.at(places[i]);
        uint32_t triangle = node.firstTriangle;
        uint32_t quadric = node.firstQuadric;
        for (uint32_t child = 0; child < 8; ++child) {
            if ((node.nodesAndExponents >> (24 + child) & 1u) != 0)
                places.push_back(node.childBase + child);
            const bool isQuadrics = (node.primitives >> (24 + child) & 1u) != 0;
            for (int left = std::popcount(node.primitives >> (3 * child) & 7u); left > 0; --left)
                ++(isQuadrics ? quadricLeaves.at(quadric++) : triangleLeaves.at(triangle++));
        }
    }
    EXPECT_EQ(triangleLeaves, std::vector<uint32_t>(100, 1));
    EXPECT_EQ(quadricLeaves, std::vector<uint32_t>(100, 1));
}

TEST(PackSceneTest, CarriesMaterialsAndTheCamera) {
    Scene scene = sceneOf({shapeOf(Sphere{{glm::dmat3(1.0), {100.0, 0.0, 0.0}}, 1.0})});
    scene.materials = materials();
    scene.camera.position = {90.0, 3.0, 0.0};
    scene.camera.verticalFov = kPi / 2.0;
    PackedScene result = packAsProgram(scene);
    const GpuScene wide =
        packScene(scene, result.primitives, result.bvh, result.packed.origin, 2.0);
    EXPECT_EQ(wide.origin, glm::dvec3(99.0, 1.0, 0.0));
    EXPECT_EQ(wide.camera.position, glm::vec3(-9.0f, 2.0f, 0.0f));
    EXPECT_NEAR(glm::distance(wide.camera.right, glm::vec3(2, 0, 0)), 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(wide.camera.up, glm::vec3(0, 1, 0)), 0.0, 1e-6);
    EXPECT_EQ(wide.camera.forward, glm::vec3(0, 0, -1));
    EXPECT_EQ(wide.quadrics[0].center, glm::vec3(1.0f, -1.0f, 0.0f));
    ASSERT_EQ(wide.materials.size(), 3u);
    EXPECT_EQ(wide.materials[0].color, glm::vec3(0.25f, 0.5f, 0.75f));
}

TEST(PackSceneTest, SpheresKeepWhatRoundingTakesFromTheirCentres) {
    const Scene scene = sceneOf({shapeOf(Sphere{{glm::dmat3(1.0), {0.1, -1e5, 0.3}}, 1e5 / 3.0})});
    const shared::Quadric sphere = packQuadric(scene.shapes[0], {0.0, 0.7, 5.0}, 0);
    const glm::dvec3 center = glm::dvec3(sphere.center) + glm::dvec3(sphere.centerRest);
    // Moved by what rounding adds to the radius, so that the near side stays.
    const double excess = double{sphere.radius} - 1e5 / 3.0;
    EXPECT_GT(std::abs(excess), 1e-4);
    const glm::dvec3 exact(0.1, -100000.7, -4.7);
    EXPECT_NEAR(glm::distance(center, exact + excess * glm::normalize(exact)), 0.0, 1e-9);
}

TEST(PackSceneTest, OfNothingHasArraysAllTheSame) {
    const GpuScene scene = packed({});
    EXPECT_EQ(scene.lightCount, 0u);
    ASSERT_EQ(scene.nodes.size(), 1u);
    EXPECT_EQ(scene.nodes[0].primitives, 0u);
    EXPECT_EQ(scene.triangles.size(), 1u);
    EXPECT_EQ(scene.quadrics.size(), 1u);
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(featuresOf(scene), Features{shared::kFeatureTriangles});
}

TEST(PackTriangleTest, NormalIsThatOfThePackedCorners) {
    RandomNumbers random(81);
    for (int i = 0; i < 10'000; ++i) {
        const double size = random.powerOfTen(-10.0, 10.0);
        const glm::vec3 v0(size * random.inBall());
        const glm::vec3 v1(size * random.inBall());
        // Needles among them.
        const glm::vec3 v2(glm::dvec3(v0) + random.powerOfTen(-5.0, 0.0) * size * random.inBall());
        const shared::Triangle packed = packTriangle(v0, v1, v2);
        const glm::dvec3 cross =
            glm::cross(glm::dvec3(v1) - glm::dvec3(v0), glm::dvec3(v2) - glm::dvec3(v0));
        const glm::dvec3 normal = cross / glm::length(cross);
        const glm::dvec3 rounded(packed.normalX, packed.normalY, packed.normalZ);
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_NEAR(rounded[axis], normal[axis], 0x1p-24 * std::abs(normal[axis]) + 1e-10);
    }
}

TEST(PackTriangleTest, NormalOfCornersThatRoundingJoinsIsTheExactOne) {
    Mesh mesh = singleTriangle({1e9, 0, 0}, {1e9, 1e-3, 0}, {1e9, 0, 1e-3});
    const shared::Triangle packed = packTriangle(mesh, 0, {0.0, 0.0, 0.0}, 0);
    EXPECT_EQ(glm::vec3(packed.normalX, packed.normalY, packed.normalZ), glm::vec3(1, 0, 0));
    mesh.positions = {{1e9, 0, 1e9}, {1e9, 1e-3, 1e9}, {1e9 + 1e-3, 0, 1e9}};
    const shared::Triangle joined = packTriangle(mesh, 0, {0.0, 0.0, 0.0}, 0);
    EXPECT_EQ(joined.v0, joined.v2);
    EXPECT_NEAR(joined.normalZ, -1.0f, 1e-6f);
}

TEST(AreaOfTest, IsThatOfTheWholeSurface) {
    const auto area = [](auto shape) { return areaOf(packQuadric(shapeOf(shape), {}, 0)); };
    EXPECT_NEAR(area(Sphere{{}, 2.0}), 16.0 * kPi, 1e-5);
    EXPECT_NEAR(area(Cylinder{{}, 2.0, 3.0}), 2.0 * 4.0 * kPi + 4.0 * kPi * 3.0, 1e-5);
    EXPECT_NEAR(area(Cone{{}, -4.0, 0.75}), 9.0 * kPi + kPi * 3.0 * 5.0, 1e-5);
    EXPECT_NEAR(area(Disk{{}, 2.0}), 4.0 * kPi, 1e-5);
    EXPECT_NEAR(areaOf(packTriangle(triangleOf(0), 0, {}, 0)), 1.0, 1e-12);
}

} // namespace
} // namespace calotype::test
