// What pixels show first, in scenes whose answers are known.
#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "support/first_hits.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"

namespace calotype::shared {

// For the comparisons below; a pixel that shows nothing has an infinite depth.
inline bool operator==(const FirstHit& a, const FirstHit& b) {
    return a.albedo == b.albedo && a.normal == b.normal && a.position == b.position &&
           a.depth == b.depth && a.primitive == b.primitive && a.uv == b.uv;
}

} // namespace calotype::shared

namespace calotype::test {
namespace {

/// Of a few operations on numbers about 1 in single precision: 16 roundings of 2^-23.
constexpr double kRounding = 16.0 / (1 << 23);

void expectNear(const glm::vec3& v, const glm::dvec3& wanted, double tolerance = kRounding) {
    EXPECT_LT(glm::distance(glm::dvec3(v), wanted), tolerance)
        << v.x << ", " << v.y << ", " << v.z << " is not " << wanted.x << ", " << wanted.y << ", "
        << wanted.z;
}

/// The point of the plane z = 0 in the middle of a pixel of `lookAtPlaneZ(side)`.
glm::dvec2 onPlane(const FirstHitImage& image, uint32_t x, uint32_t y, double side) {
    return {((x + 0.5) / image.width - 0.5) * side * image.width / image.height,
            (0.5 - (y + 0.5) / image.height) * side};
}

/// A square of 2 x 2 metres about the origin in the plane z = `z`.
SceneBuilder& addSquare(SceneBuilder& builder, double z, uint32_t material,
                        bool mirroredU = false) {
    return builder.rectangle({-1.0, -1.0, z}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, material,
                             mirroredU);
}

class FirstHitTest : public GpuTest {};

TEST_F(FirstHitTest, OfNothingIsTheDefault) {
    SceneBuilder builder;
    builder.scene().background = glm::dvec3(1.0);
    const FirstHits hits = firstHitsOf(builder.scene());
    ASSERT_EQ(hits.image.pixels.size(), 256u);
    for (const FirstHit& hit : hits.image.pixels) {
        EXPECT_EQ(hit, FirstHit{});
        EXPECT_EQ(hit.depth, std::numeric_limits<float>::infinity());
        EXPECT_EQ(hit.primitive, 0xFFFFFFFFu);
    }
}

// Without a texture in the scene too, and whichever way they run.
TEST_F(FirstHitTest, OfASquareIsItsPlaneAndItsCoordinates) {
    for (const bool mirroredU : {false, true}) {
        SceneBuilder builder;
        addSquare(builder, 0.0, builder.material(0.5, 0.0), mirroredU).lookAtPlaneZ(4.0);
        builder.scene().film = {20, 12};
        const FirstHitImage image = firstHitsOf(builder.scene()).image;
        for (uint32_t y = 0; y < image.height; ++y)
            for (uint32_t x = 0; x < image.width; ++x) {
                const FirstHit& hit = image.at(x, y);
                const glm::dvec2 p = onPlane(image, x, y, 4.0);
                if (std::abs(p.x) > 1.0 || std::abs(p.y) > 1.0) {
                    EXPECT_EQ(hit, FirstHit{}) << x << "," << y;
                    continue;
                }
                expectNear(hit.position, glm::dvec3(p, 0.0));
                expectNear(hit.normal, {0.0, 0.0, 1.0});
                EXPECT_EQ(hit.albedo, glm::vec3(0.5f));
                EXPECT_NEAR(hit.depth, 5.0, 5.0 * kRounding);
                EXPECT_LT(hit.primitive, 2u);
                if (std::abs(p.x - p.y) > kRounding) // else on the diagonal: either triangle's
                    EXPECT_EQ(hit.primitive, p.y < p.x ? 0u : 1u) << x << "," << y;
                const double u = 0.5 + 0.5 * p.x;
                EXPECT_NEAR(hit.uv.x, mirroredU ? 1.0 - u : u, kRounding);
                EXPECT_NEAR(hit.uv.y, 0.5 + 0.5 * p.y, kRounding);
            }
    }
}

// Along the axis, not along the ray: of a wall across the view it is the same everywhere.
TEST_F(FirstHitTest, DepthIsThatOfTheCamerasAxis) {
    SceneBuilder builder;
    builder.rectangle({-9, 0, -9}, {0, 0, 18}, {18, 0, 0}, builder.material(0.5, 0.0));
    builder.lookDown(3.0, 6.0);
    const FirstHitImage image = firstHitsOf(builder.scene()).image;
    for (const FirstHit& hit : image.pixels)
        EXPECT_NEAR(hit.depth, 3.0, 3.0 * kRounding);
    expectNear(image.at(0, 15).position, {-3.0 + 3.0 / 16, 0.0, 3.0 - 3.0 / 16}, 3.0 * kRounding);
}

TEST_F(FirstHitTest, PrimitivesAreNumberedInTheOrderOfTheScene) {
    SceneBuilder builder;
    const uint32_t grey = builder.material(0.5, 0.0);
    // From right to left: balls in the top row, each with a rectangle of two pixels below it.
    for (const double x : {3.5, 1.5, -0.5, -2.5}) {
        builder.add(makeShape(Sphere{{glm::dmat3(1.0), {x, 1.5, 0.0}}, 0.4}, grey));
        builder.rectangle({x - 1.5, -1.0, 0.0}, {2, 0, 0}, {0, 1, 0}, grey);
    }
    builder.lookAtPlaneZ(4.0).scene().film = {8, 4};
    const FirstHitImage image = firstHitsOf(builder.scene()).image;
    for (uint32_t i = 0; i < 4; ++i) {
        EXPECT_EQ(image.at(7 - 2 * i, 0).primitive, 3 * i);
        EXPECT_EQ(image.at(7 - 2 * i, 2).primitive, 3 * i + 1);
        EXPECT_EQ(image.at(6 - 2 * i, 2).primitive, 3 * i + 2);
        EXPECT_EQ(image.at(7 - 2 * i, 3).primitive, kNoPrimitive);
    }
}

// The film's filter and the lens blur pictures, not these.
TEST_F(FirstHitTest, NeitherLensNorFilterMatters) {
    Scene scene = projectScene("tests/image/scenes/everything.json");
    scene.film = {48, 40};
    for (const auto projection : {Projection::Perspective, Projection::Orthographic}) {
        scene.camera.projection = projection;
        scene.camera.viewHeight = 3.0;
        scene.camera.lensRadius = 0.0;
        scene.film.filter = FilmFilter::Box;
        const FirstHits sharp = firstHitsOf(scene);
        scene.camera.lensRadius = 0.3;
        scene.film.filter = FilmFilter::Gaussian;
        EXPECT_TRUE(sharp.image.pixels == firstHitsOf(scene).image.pixels);
        EXPECT_NE(sharp.image.at(24, 20).primitive, kNoPrimitive);
    }
}

TEST_F(FirstHitTest, CropIsAPartOfTheWhole) {
    Scene scene = projectScene("tests/image/scenes/everything.json");
    scene.film = {150, 90}; // more tiles than the first dispatch takes
    const FirstHitImage whole = firstHitsOf(scene).image;
    FirstHitWish wish;
    wish.crop = Crop{13, 7, 121, 78};
    const FirstHitImage crop = firstHitsOf(scene, wish).image;
    ASSERT_EQ(crop.width, 121u);
    ASSERT_EQ(crop.height, 78u);
    uint32_t shown = 0;
    for (uint32_t y = 0; y < crop.height; ++y)
        for (uint32_t x = 0; x < crop.width; ++x) {
            ASSERT_EQ(crop.at(x, y), whole.at(x + 13, y + 7)) << x << "," << y;
            shown += crop.at(x, y).primitive != kNoPrimitive ? 1 : 0;
        }
    EXPECT_GT(shown, 1000u);
}

// Specialising only removes code.
TEST_F(FirstHitTest, SpecialisedKernelEqualsEverythingOn) {
    for (const char* path : {"scenes/cornell-box.json", "scenes/texture.json", "scenes/cone.json",
                             "scenes/depth-of-field.json", "tests/image/scenes/everything.json"}) {
        SCOPED_TRACE(path);
        Scene scene = projectScene(path);
        scene.film.width = 48;
        scene.film.height = 40;
        FirstHitWish wish;
        wish.features = SceneFeatures::all();
        EXPECT_TRUE(firstHitsOf(scene).image.pixels == firstHitsOf(scene, wish).image.pixels);
    }
}

/// A ball before a wall, of numbers that survive being moved by whole numbers of metres.
Scene movedScene(const glm::dvec3& offset) {
    SceneBuilder builder;
    const uint32_t grey = builder.material(0.5, 0.0);
    builder.add(
        makeShape(Sphere{{glm::dmat3(1.0), offset + glm::dvec3(0.5, 0.0, 1.0)}, 0.75}, grey));
    builder.rectangle(offset + glm::dvec3(-2.0, -1.0, 0.0), {4.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, grey);
    Scene& scene = builder.scene();
    scene.camera.position = offset + glm::dvec3(0.25, 0.0, 6.0);
    return scene;
}

// The packed scene has an origin of its own; of all layers only positions depend on it.
TEST_F(FirstHitTest, FarAwayIsTheSameButForPositions) {
    const glm::dvec3 offset(3'000'000.0, -700'000.0, 20'000.0);
    const FirstHitImage near = firstHitsOf(movedScene(glm::dvec3(0.0))).image;
    const FirstHitImage far = firstHitsOf(movedScene(offset)).image;
    uint32_t shown = 0;
    for (size_t i = 0; i < near.pixels.size(); ++i) {
        FirstHit moved = far.pixels[i];
        if (moved.primitive != kNoPrimitive) {
            ++shown;
            for (int axis = 0; axis < 3; ++axis) {
                const double wanted = double(near.pixels[i].position[axis]) + offset[axis];
                // Half a unit in float's last place, and the near position's own rounding.
                EXPECT_NEAR(moved.position[axis], wanted, 0x1p-24 * std::abs(wanted) + kRounding);
            }
        }
        moved.position = near.pixels[i].position;
        EXPECT_EQ(moved, near.pixels[i]);
    }
    EXPECT_GT(shown, 50u);
    EXPECT_LT(shown, 256u);
}

TEST_F(FirstHitTest, ProgressIsHeardAndMayEndIt) {
    SceneBuilder builder;
    builder.scene().film = {640, 480};
    double last = 0.0;
    uint32_t calls = 0;
    FirstHitWish wish;
    wish.onProgress = [&](double done) {
        EXPECT_GT(done, last);
        last = done;
        ++calls;
    };
    firstHitsOf(builder.scene(), wish);
    EXPECT_EQ(last, 1.0);
    EXPECT_GT(calls, 1u);
    wish.onProgress = [](double) { throw std::runtime_error("enough"); };
    EXPECT_THROW(firstHitsOf(builder.scene(), wish), std::runtime_error);
}

} // namespace
} // namespace calotype::test
