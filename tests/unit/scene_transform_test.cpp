// Transforms, axes and what they make of shapes, against values worked out by hand.

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "math/affine_transform.h"
#include "math/rotation.h"
#include "scene_files.h"

namespace calotype::test {
namespace {

/// A few roundings of numbers below ten.
constexpr double kRounding = 1e-14;

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected,
                double tolerance = kRounding) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

template <typename Geometry>
Geometry shapeOf(const std::string& shape) {
    const SceneFiles files;
    return std::get<Geometry>(files.load(sceneWithShape(shape)).shapes.at(0).geometry);
}

TEST(RotationTest, TurnsAboutXThenYThenZ) {
    // X by 90: y -> z. Then Y by 90: z -> x. Then Z by 90: x -> y.
    expectNear(rotationFromDegrees({90, 90, 90}) * glm::dvec3(0, 1, 0), {0, 1, 0}, 0.0);
    expectNear(rotationFromDegrees({90, 0, 0}) * glm::dvec3(0, 1, 0), {0, 0, 1}, 0.0);
    expectNear(rotationFromDegrees({0, 90, 0}) * glm::dvec3(0, 0, 1), {1, 0, 0}, 0.0);
    expectNear(rotationFromDegrees({0, 0, 90}) * glm::dvec3(1, 0, 0), {0, 1, 0}, 0.0);
    expectNear(rotationFromDegrees({0, 90, 90}) * glm::dvec3(0, 0, 1), {0, 1, 0}, 0.0);
}

TEST(RotationTest, IsExactAtQuarterTurnsHoweverMany) {
    for (const double turns : {-4e6, -3.0, -1.0, 1.0, 2.0, 7.0, 4e9 + 1.0}) {
        const glm::dmat3 r = rotationFromDegrees({0, 0, 90.0 * turns});
        const int quarter = static_cast<int>(((static_cast<int64_t>(turns) % 4) + 4) % 4);
        const std::vector<glm::dvec3> images = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
        EXPECT_EQ(r * glm::dvec3(1, 0, 0), images[quarter]) << turns;
    }
    const double half = std::sqrt(0.5);
    expectNear(rotationFromDegrees({0, 0, 45}) * glm::dvec3(1, 0, 0), {half, half, 0});
    expectNear(rotationFromDegrees({0, 0, 30}) * glm::dvec3(1, 0, 0),
               {half * half * std::sqrt(3.0), 0.5, 0});
}

TEST(RotationTest, TakesYToAnyDirection) {
    EXPECT_EQ(rotationTakingYTo({0, 1, 0}), glm::dmat3(1.0));
    std::vector<glm::dvec3> directions = {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}, {0, -0.0, 1}};
    for (const double tiny : {1e-3, 1e-8, 1e-17, 1e-300}) {
        directions.push_back(glm::normalize(glm::dvec3(tiny, 1, -tiny)));
        directions.push_back(glm::normalize(glm::dvec3(tiny, -1, tiny)));
        directions.push_back(glm::normalize(glm::dvec3(1, -tiny, 1)));
    }
    for (const glm::dvec3& direction : directions) {
        const glm::dmat3 r = rotationTakingYTo(direction);
        EXPECT_EQ(r * glm::dvec3(0, 1, 0), direction);
        const glm::dmat3 product = glm::transpose(r) * r;
        for (int i = 0; i < 3; ++i)
            expectNear(product[i], glm::dmat3(1.0)[i], 1e-15);
        EXPECT_NEAR(glm::determinant(r), 1.0, 1e-15);
    }
}

TEST(AffineTransformTest, SeparatesSingularFromExtreme) {
    EXPECT_FALSE(isSingular(glm::dmat3(1e-200)));
    EXPECT_FALSE(isSingular(glm::dmat3(1e200)));
    EXPECT_FALSE(isSingular({1, 0, 0, 0, 1e-30, 0, 0, 0, 1}));
    EXPECT_FALSE(isSingular({1e99, 0, 0, 0, 1, 0, 0, 0, 1}));
    EXPECT_TRUE(isSingular({1e101, 0, 0, 0, 1, 0, 0, 0, 1}));
    EXPECT_TRUE(isSingular({1e300, 0, 0, 0, 1e-300, 0, 0, 0, 1}));
    EXPECT_TRUE(isSingular(glm::dmat3(0.0)));
    EXPECT_TRUE(isSingular({1, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_TRUE(isMirroring({1e-200, 0, 0, 0, -1e-200, 0, 0, 0, 1e-200}));
}

TEST(AffineTransformTest, SimilarityAllowsTypedDigitsOnly) {
    EXPECT_TRUE(asSimilarity({glm::dmat3(1e-200), {}}));
    EXPECT_FALSE(asSimilarity({{1, 0, 0, 0, 1.0001, 0, 0, 0, 1}, {}}));
    // A rotation by 45 degrees, doubled, typed to six digits.
    const auto typed = asSimilarity({{1.41421, 1.41421, 0, -1.41421, 1.41421, 0, 0, 0, 2}, {}});
    ASSERT_TRUE(typed);
    EXPECT_NEAR(typed->scale, 2.0, 1e-5);
    const double half = std::sqrt(0.5);
    expectNear(typed->rigid.rotation[0], {half, half, 0});
}

TEST(SceneTransformTest, QuadricsFoldTheScaleIntoTheirSizes) {
    const Sphere sphere = shapeOf<Sphere>(R"({"type": "sphere", "material": "wall", "radius": 0.5,
        "center": [1, 0, 0],
        "transform": {"translate": [10, 0, 0], "rotate": [0, 0, 90], "scale": 3}})");
    EXPECT_EQ(sphere.radius, 1.5);
    EXPECT_EQ(sphere.worldFromObject.translation, glm::dvec3(10, 3, 0));

    const Cone cone = shapeOf<Cone>(R"({"type": "cone", "material": "wall", "apex": [0, 1, 0],
        "height": -2, "slope": 0.25, "transform": {"rotate": [90, 0, 0], "scale": 2}})");
    EXPECT_EQ(cone.height, -4.0);
    EXPECT_EQ(cone.slope, 0.25);
    EXPECT_EQ(cone.worldFromObject.translation, glm::dvec3(0, 0, 2));
    EXPECT_EQ(cone.worldFromObject.direction({0, 1, 0}), glm::dvec3(0, 0, 1));
}

TEST(SceneTransformTest, MirroredQuadricsKeepTheirOutside) {
    const Disk disk = shapeOf<Disk>(R"({"type": "disk", "material": "wall", "radius": 1,
        "normal": [1, 0, 0], "center": [1, 0, 0], "transform": {"scale": [-2, 2, 2]}})");
    EXPECT_EQ(disk.radius, 2.0);
    EXPECT_EQ(disk.worldFromObject.translation, glm::dvec3(-2, 0, 0));
    EXPECT_EQ(disk.worldFromObject.direction({0, 1, 0}), glm::dvec3(-1, 0, 0));
    EXPECT_EQ(glm::determinant(disk.worldFromObject.rotation), -1.0);
}

TEST(SceneTransformTest, AxisReplacesY) {
    const Cylinder cylinder = shapeOf<Cylinder>(R"({"type": "cylinder", "material": "wall",
        "center": [1, 2, 3], "radius": 0.5, "height": 4, "axis": [0, 0, -7]})");
    EXPECT_EQ(cylinder.worldFromObject.direction({0, 1, 0}), glm::dvec3(0, 0, -1));
    EXPECT_EQ(cylinder.worldFromObject.translation, glm::dvec3(1, 2, 3));
    EXPECT_EQ(cylinder.height, 4.0);
}

TEST(SceneTransformTest, MatrixIsRowMajor) {
    const Sphere sphere = shapeOf<Sphere>(R"({"type": "sphere", "material": "wall", "radius": 1,
        "center": [1, 2, 3], "transform": {"matrix": [0,-2,0,10, 2,0,0,20, 0,0,2,30, 0,0,0,1]}})");
    EXPECT_EQ(sphere.worldFromObject.translation, glm::dvec3(6, 22, 36));
    EXPECT_EQ(sphere.radius, 2.0);
}

TEST(SceneTransformTest, MeshesAcceptAnyScaleAndKeepTheirFronts) {
    const std::string triangle = R"({"type": "triangle", "material": "wall",
        "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "transform": {"scale": )";
    const auto normalOf = [](const Mesh& mesh) {
        const auto& p = mesh.triangles.at(0).position;
        return glm::cross(mesh.positions[p[1]] - mesh.positions[p[0]],
                          mesh.positions[p[2]] - mesh.positions[p[0]]);
    };
    EXPECT_EQ(normalOf(shapeOf<Mesh>(triangle + "[2, 3, 1]}}")), glm::dvec3(0, 0, 6));
    // Mirrored in X the front still looks along +Z; mirrored in Z, along -Z.
    EXPECT_EQ(normalOf(shapeOf<Mesh>(triangle + "[-2, 3, 1]}}")), glm::dvec3(0, 0, 6));
    EXPECT_EQ(normalOf(shapeOf<Mesh>(triangle + "[2, 3, -1]}}")), glm::dvec3(0, 0, -6));
}

TEST(SceneTransformTest, QuadsAreTwoTrianglesInOnePlane) {
    const Mesh quad = shapeOf<Mesh>(R"({"type": "quad", "material": "wall",
        "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]})");
    ASSERT_EQ(quad.triangles.size(), 2u);
    EXPECT_EQ(quad.positions.size(), 4u);
    EXPECT_EQ(quad.triangles[1].position[0], quad.triangles[0].position[0]);
    EXPECT_EQ(quad.triangles[1].position[1], quad.triangles[0].position[2]);
    // One corner lifted by h: all four lie h/4 off their plane, next to a size of sqrt(2).
    const std::string start = R"({"type": "quad", "material": "wall",
        "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, )";
    EXPECT_NO_THROW(shapeOf<Mesh>(start + "5.6e-4], [0, 1, 0]]}"));
    EXPECT_THROW(shapeOf<Mesh>(start + "5.7e-4], [0, 1, 0]]}"), SceneError);
}

TEST(SceneTransformTest, HalfAQuadIsKeptWithAWarning) {
    const SceneFiles files;
    const Scene scene = files.load(sceneWithShape(R"({"type": "quad", "material": "wall",
        "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 0]]})"));
    EXPECT_EQ(std::get<Mesh>(scene.shapes.at(0).geometry).triangles.size(), 1u);
    EXPECT_EQ(scene.droppedTriangles, 1u);
    EXPECT_NE(scene.warnings.at(0).find("/shapes/0: half of the quad"), std::string::npos);
}

TEST(SceneTransformTest, RefusesShapesBeyondFiniteNumbers) {
    const std::string huge = R"("transform": {"scale": 1e200}})";
    expectError(errorOf([&] {
                    shapeOf<Mesh>(R"({"type": "triangle", "material": "wall",
                        "vertices": [[0, 0, 0], [1e200, 0, 0], [0, 1, 0]], )" +
                                  huge);
                }),
                "scene.json: /shapes/0", "beyond the range of finite numbers");
    expectError(errorOf([&] {
                    shapeOf<Sphere>(R"({"type": "sphere", "material": "wall", "radius": 1e200, )" +
                                    huge);
                }),
                "scene.json: /shapes/0/radius", "beyond");
    expectError(errorOf([&] {
                    shapeOf<Sphere>(R"({"type": "sphere", "material": "wall", "radius": 1,
                        "center": [0, 1e200, 0], )" +
                                    huge);
                }),
                "scene.json: /shapes/0", "beyond");
}

} // namespace
} // namespace calotype::test
