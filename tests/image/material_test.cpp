// Every material under light from all directions: the radiance of a surface is its albedo, by the
// equations of docs/models.md integrated in double precision; lossless glass disappears.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "image/coarse_ball.h"
#include "support/gpu_test.h"
#include "support/image_means.h"
#include "support/oracle_bsdf.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"
#include "support/slow_run.h"
#include "support/statistics.h"
#include "support/test_materials.h"

namespace calotype::test {
namespace {

/// The share of uniform light from all directions that leaves towards wo.
double albedo(const Material& material, const glm::dvec3& wo) {
    constexpr int kSteps = 600;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const double cosTheta = (i + 0.5) / kSteps;
            const double phi = 2.0 * std::numbers::pi * (j + 0.5) / kSteps;
            sum += oracleValue(material, wo, directionAt(cosTheta, phi)).x;
        }
    return sum * 2.0 * std::numbers::pi / (kSteps * kSteps);
}

/// The strip of a plane through the origin between two heights, tilted about y so that parallel
/// rays along -z meet it at an angle of the given cosine.
void addTiltedPlane(SceneBuilder& builder, double cosTheta, uint32_t material, double bottom = -2.0,
                    double top = 2.0) {
    const glm::dvec3 right(cosTheta, 0.0, -std::sqrt(1.0 - cosTheta * cosTheta));
    builder.rectangle(-2.0 * right + glm::dvec3(0.0, bottom, 0.0), 4.0 * right,
                      {0.0, top - bottom, 0.0}, material);
}

enum class Surroundings { EmittingSphere, Background };

void surround(SceneBuilder& builder, Surroundings surroundings) {
    if (surroundings == Surroundings::Background) {
        builder.scene().background = glm::dvec3(1.0);
        return;
    }
    const uint32_t glow = builder.material(0.0, 1.0);
    builder.add(makeShape(Sphere{{}, 20.0}, glow));
}

class MaterialTest : public GpuTest {
protected:
    /// One picture of all of them, each a strip of one plane: none lights another.
    static void expectAlbedos(const std::vector<TestMaterial>& tests, double cosTheta,
                              Surroundings surroundings) {
        constexpr uint32_t kColumns = 144;
        constexpr uint32_t kRows = 16;   ///< that are judged of each strip
        constexpr uint32_t kBorder = 2;  ///< rows beside them, which a filter mixes
        constexpr double kHeight = 0.04; ///< of a strip, metres
        SceneBuilder builder;
        const auto count = static_cast<uint32_t>(tests.size());
        const double top = 0.5 * kHeight * count;
        for (uint32_t i = 0; i < count; ++i)
            addTiltedPlane(builder, cosTheta, builder.material(tests[i].material),
                           top - (i + 1) * kHeight, top - i * kHeight);
        surround(builder, surroundings);
        builder.lookAtPlaneZ(2.0 * top);
        Scene& scene = builder.scene();
        scene.film = {kColumns, (kRows + 2 * kBorder) * count};
        scene.render = {quickOrFull(16u, 64u), 1, 0};
        const Image image = renderScene(scene).image;
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t first = (kRows + 2 * kBorder) * i + kBorder;
            std::vector<double> pixels;
            for (uint32_t y = first; y < first + kRows; ++y)
                for (uint32_t x = 0; x < kColumns; ++x)
                    pixels.push_back(image.at(x, y).x);
            const Estimate seen = estimate(pixels);
            const double wanted = albedo(tests[i].material, directionAt(cosTheta, 0.0));
            EXPECT_NEAR(seen.mean, wanted, 4.0 * seen.standardError + 0.002 * wanted)
                << tests[i].name << ", cosine " << cosTheta;
        }
    }
};

TEST_F(MaterialTest, ShowsItsAlbedoInAnEmittingSphere) {
    std::vector<TestMaterial> tests = testMaterials();
    std::erase_if(tests, [](const TestMaterial& test) {
        return test.lobeWidth < 0.05; // too narrow for the sum above
    });
    for (const double cosTheta : {0.95, 0.3})
        expectAlbedos(tests, cosTheta, Surroundings::EmittingSphere);
}
ALSO_SLOW(MaterialTest, ShowsItsAlbedoInAnEmittingSphere);

TEST_F(MaterialTest, ShowsItsAlbedoUnderABackground) {
    std::vector<TestMaterial> tests = testMaterials();
    std::erase_if(tests, [](const TestMaterial& test) {
        return test.lobeWidth < 0.3 || test.material.masking == Masking::Smith;
    });
    expectAlbedos(tests, 0.6, Surroundings::Background);
}
ALSO_SLOW(MaterialTest, ShowsItsAlbedoUnderABackground);

// Too narrow for the sum: a mirror shows F G1^2 of what is all around, a varnish that and its base.
TEST_F(MaterialTest, MirrorsShowTheirAlbedo) {
    for (const MaterialType type : {MaterialType::Metal, MaterialType::Nonmetal})
        for (const double cosTheta : {0.95, 0.3}) {
            SceneBuilder builder;
            Material mirror;
            mirror.type = type;
            mirror.color = glm::dvec3(0.6);
            addTiltedPlane(builder, cosTheta, builder.material(mirror));
            surround(builder, Surroundings::EmittingSphere);
            builder.lookAtPlaneZ(0.1);
            Scene& scene = builder.scene();
            scene.film = {48, 48};
            scene.render = {64, 1, 0};
            const bool metal = type == MaterialType::Metal;
            const double f0 = metal ? 0.6 : 0.04;
            const double g1 = cosTheta / (cosTheta * 0.875 + 0.125);
            const double wanted = (f0 + (1.0 - f0) * std::pow(1.0 - cosTheta, 5)) * g1 * g1 +
                                  (metal ? 0.0 : 0.96 * 0.6);
            EXPECT_NEAR(imageMean(renderScene(scene).image).x, wanted, 0.003 * wanted);
        }
}

// A background beside a lamp is chosen now and then only, and divided by its chance: together they
// light as each alone, added up.
TEST_F(MaterialTest, BackgroundAndLampAddUp) {
    const auto radiance = [](bool background, bool lamp) {
        SceneBuilder builder;
        addTiltedPlane(builder, 0.8, builder.material(0.7, 0.0));
        if (lamp)
            builder.rectangle({-1.0, -1.0, 6.0}, {0.0, 2.0, 0.0}, {2.0, 0.0, 0.0},
                              builder.material(0.0, 9.0));
        builder.scene().background = glm::dvec3(background ? 0.4 : 0.0);
        builder.lookAtPlaneZ(0.1);
        builder.scene().film = {48, 48};
        builder.scene().render = {128, 1, 0};
        return imageMean(renderScene(builder.scene()).image).x;
    };
    const double lampHides = 0.4 * radiance(false, true) / 9.0; // of the background behind it
    const double together = radiance(true, true);
    EXPECT_NEAR(together, radiance(true, false) + radiance(false, true) - lampHides,
                0.004 * together);
}

// Light that enters glass leaves it in the end, undiminished: the object is not to be seen.
void expectInvisible(Shape shape, Surroundings surroundings) {
    SceneBuilder builder;
    Material glass;
    glass.type = MaterialType::Dielectric;
    glass.color = glm::dvec3(1.0);
    glass.ior = 1.5;
    shape.material = builder.material(glass);
    if (auto* mesh = std::get_if<Mesh>(&shape.geometry))
        for (Mesh::Triangle& triangle : mesh->triangles)
            triangle.material = shape.material;
    builder.add(std::move(shape));
    surround(builder, surroundings);
    builder.lookAtPlaneZ(2.2);
    Scene& scene = builder.scene();
    scene.film = {48, 48};
    scene.render = {32, 200, 3};
    const RenderedScene result = renderScene(scene);
    EXPECT_NEAR(imageMean(result.image).x, 1.0, 0.001);
    for (const glm::vec3& pixel : result.image.pixels)
        EXPECT_NEAR(pixel.x, 1.0, 0.1); // three paths in 32, at most, stay for all events
    EXPECT_EQ(result.totals.losses.nonFiniteSamples, 0u);
}

TEST_F(MaterialTest, GlassSphereDisappears) {
    expectInvisible(makeShape(Sphere{{}, 0.9}, 0), Surroundings::EmittingSphere);
    expectInvisible(makeShape(Sphere{{}, 0.9}, 0), Surroundings::Background);
}

TEST_F(MaterialTest, GlassCylinderDisappears) {
    const RigidTransform tilted{glm::dmat3(0.8, 0.6, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0, 1.0), {}};
    expectInvisible(makeShape(Cylinder{tilted, 0.4, 1.2}, 0), Surroundings::EmittingSphere);
}

TEST_F(MaterialTest, GlassConeDisappears) {
    const RigidTransform raised{glm::dmat3(1.0), {0.0, 0.8, 0.0}};
    expectInvisible(makeShape(Cone{raised, -1.6, 0.5}, 0), Surroundings::EmittingSphere);
}

TEST_F(MaterialTest, GlassMeshOfSmoothNormalsDisappears) {
    expectInvisible(makeShape(coarseBall(4), 0), Surroundings::EmittingSphere);
}

// Glass tints each crossing; a slab is crossed twice, but for what is reflected inside.
TEST_F(MaterialTest, TintColoursEachCrossing) {
    SceneBuilder builder;
    Material glass;
    glass.type = MaterialType::Dielectric;
    glass.color = {1.0, 0.5, 0.25};
    glass.ior = 1.0; // nothing is reflected, so every path crosses twice
    builder.add(makeShape(Sphere{{}, 0.9}, builder.material(glass)));
    surround(builder, Surroundings::EmittingSphere);
    builder.lookAtPlaneZ(0.5);
    Scene& scene = builder.scene();
    scene.render = {16, 8, 0};
    for (const glm::vec3& pixel : renderScene(scene).image.pixels) {
        EXPECT_NEAR(pixel.x, 1.0, 1e-5);
        EXPECT_NEAR(pixel.y, 0.25, 1e-5);
        EXPECT_NEAR(pixel.z, 0.0625, 1e-5);
    }
}

} // namespace
} // namespace calotype::test
