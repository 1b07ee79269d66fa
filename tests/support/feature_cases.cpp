#include "support/feature_cases.h"

#include <memory>

#include "shared/specialization.h"

namespace calotype::test {
namespace {

constexpr uint32_t kFloor = 0; ///< the material of the floor and of what stands on it
constexpr uint32_t kLamp = 1;

Texture noiseTexture(bool floats, bool transparent = false) {
    auto image = std::make_shared<TexelImage>();
    image->width = 5;
    image->height = 4;
    image->isEncoded = true;
    image->isTransparent = transparent;
    for (uint32_t i = 0; i < 80; ++i) {
        const bool alpha = i % 4 == 3;
        const uint32_t value = alpha && !transparent ? 255 : 60 + i * 97 % 180;
        if (floats)
            image->floats.push_back(static_cast<float>(value) / 255.0f);
        else
            image->bytes.push_back(static_cast<uint8_t>(value));
    }
    return {"noise", ImageTexture{image}};
}

Material ofType(MaterialType type) {
    Material material;
    material.type = type;
    material.color = {0.8, 0.6, 0.4};
    material.roughness = 0.3;
    material.specular = 0.5;
    material.kd = 0.5;
    material.ks = 0.3;
    material.exponent = 30.0;
    return material;
}

void addBall(SceneBuilder& builder, const Material& material, double x = 0.0) {
    builder.add(
        makeShape(Sphere{{glm::dmat3(1.0), {x, 0.0, 0.0}}, 0.5}, builder.material(material)));
}

SceneChange ball(Material material) {
    return [material](SceneBuilder& builder) { addBall(builder, material); };
}

SceneChange shape(Shape added) {
    return [added](SceneBuilder& builder) { builder.add(added); };
}

/// The shape with a material that glows.
SceneChange light(Shape added) {
    return [added](SceneBuilder& builder) {
        Shape lamp = added;
        lamp.material = builder.material(0.2, 1.5);
        builder.add(lamp);
    };
}

SceneChange floorTexture(uint32_t Material::*slot, Texture texture,
                         MaterialType type = MaterialType::Diffuse) {
    return [=](SceneBuilder& builder) {
        Material material = ofType(type);
        material.*slot = builder.texture(texture);
        builder.scene().materials[kFloor] = material;
    };
}

SceneChange camera(const std::function<void(Scene&)>& change) {
    return [change](SceneBuilder& builder) { change(builder.scene()); };
}

const Shape kBall = makeShape(Sphere{{}, 0.5}, kFloor);
const Shape kCan = makeShape(Cylinder{{}, 0.3, 0.9}, kFloor);
const Shape kHat = makeShape(Cone{{glm::dmat3(1.0), {0.0, 0.5, 0.0}}, -0.9, 0.5}, kFloor);
const Shape kPlate = makeShape(Disk{{}, 0.6}, kFloor);

void addSmoothTriangle(SceneBuilder& builder) {
    Mesh mesh;
    mesh.positions = {{-0.7, -0.4, 0.0}, {0.7, -0.4, 0.0}, {0.0, 0.7, -0.3}};
    mesh.normals = {{-0.6, 0.0, 0.8}, {0.6, 0.0, 0.8}, {0.0, 0.6, 0.8}};
    mesh.triangles = {{{0, 1, 2}, {0, 1, 2}, kFloor}};
    builder.add(makeShape(mesh, kFloor));
}

/// So many and so large that rays are tested against quadrics as often as against triangles.
void addBalls(SceneBuilder& builder) {
    for (int i = 0; i < 24; ++i)
        builder.add(makeShape(
            Sphere{{glm::dmat3(1.0), {-1.5 + 0.6 * (i % 6), -0.1 + 0.6 * (i / 6), -1.0}}, 0.4},
            kFloor));
}

constexpr uint32_t kSmallLamps = 40; ///< more than the alias table gets

void addSmallLamps(SceneBuilder& builder) {
    const uint32_t glow = builder.material(0.1, 3.0, true);
    for (uint32_t i = 0; i < kSmallLamps; ++i) {
        const double x = -1.8 + 0.4 * (i % 10);
        const double z = -1.0 + 0.6 * double(i / 10);
        builder.polygon({{x, 0.2, z}, {x + 0.1, 0.2, z}, {x, 0.2, z + 0.1}}, glow);
    }
}

void hideLamp(Scene& scene) {
    scene.materials[kLamp].visibleToCamera = false;
    scene.camera.position = {0.0, 3.5, 0.1};
    scene.camera.forward = {0.0, -1.0, 0.0};
    scene.camera.up = {0.0, 0.0, -1.0};
}

void darken(Scene& scene) {
    for (Material& material : scene.materials)
        material.emission = glm::dvec3(0.0);
}

void darkenDisk(Scene& scene) { scene.materials.back().emission = glm::dvec3(0.0); }

/// The two functions of a FeatureCase.
struct CaseOfFeature {
    SceneChange change;
    std::function<void(Scene&)> removal = {};
};

const CaseOfFeature kTrianglesCase = {camera([](Scene&) {}),
                                      [](Scene& scene) { scene.shapes.clear(); }};
const CaseOfFeature kSmoothNormalsCase = {addSmoothTriangle};
const CaseOfFeature kSpheresCase = {shape(kBall)};
const CaseOfFeature kCylindersCase = {shape(kCan)};
const CaseOfFeature kConesCase = {shape(kHat)};
const CaseOfFeature kDisksCase = {shape(kPlate)};
const CaseOfFeature kManyQuadricsCase = {
    addBalls, [](Scene& scene) { scene.shapes.resize(litFloor().scene().shapes.size()); }};
const CaseOfFeature kTriangleLightsCase = {camera([](Scene&) {}), darken};
const CaseOfFeature kSphereLightsCase = {light(kBall)};
const CaseOfFeature kCylinderLightsCase = {light(kCan)};
const CaseOfFeature kConeLightsCase = {light(kHat)};
const CaseOfFeature kDiskLightsCase = {light(kPlate), darkenDisk};
const CaseOfFeature kHiddenLightsCase = {camera(hideLamp)};
const CaseOfFeature kLightAlphaCase = {
    camera([](Scene& scene) { scene.materials[kLamp].opacity = 0.5; })};
const CaseOfFeature kSolidAngleLightsCase = {camera([](Scene&) {})};
const CaseOfFeature kLightTreeCase = {
    addSmallLamps, [](Scene& scene) { scene.shapes.resize(scene.shapes.size() - kSmallLamps); }};
const CaseOfFeature kBackgroundLightsCase = {
    camera([](Scene& scene) {
        scene.background = {0.3, 0.4, 0.5};
    }),
    [](Scene& scene) { scene.background = glm::dvec3(0.0); }};
const CaseOfFeature kDiffuseCase = {camera([](Scene&) {})};
const CaseOfFeature kGgxCase = {ball(ofType(MaterialType::Nonmetal))};
const CaseOfFeature kMirrorsCase = {[](SceneBuilder& builder) {
    Material chrome = ofType(MaterialType::Metal);
    chrome.roughness = 0.0;
    addBall(builder, chrome, -0.6);
    chrome.type = MaterialType::Nonmetal;
    addBall(builder, chrome, 0.6);
}};
const CaseOfFeature kBlinnPhongCase = {ball(ofType(MaterialType::BlinnPhong))};
const CaseOfFeature kDielectricCase = {ball(ofType(MaterialType::Dielectric))};
const CaseOfFeature kColorTexturesCase = {
    floorTexture(&Material::colorTexture, noiseTexture(false))};
const CaseOfFeature kRoughnessTexturesCase = {
    floorTexture(&Material::roughnessTexture, noiseTexture(false), MaterialType::Nonmetal)};
const CaseOfFeature kSpecularTexturesCase = {
    floorTexture(&Material::specularTexture, noiseTexture(false), MaterialType::Nonmetal)};
const CaseOfFeature kNormalMapsCase = {
    floorTexture(&Material::normalMap, noiseTexture(false), MaterialType::Metal)};
const CaseOfFeature kAlphaCase = {floorTexture(&Material::alphaTexture, noiseTexture(false, true))};
const CaseOfFeature kCutOutColorsCase = {[](SceneBuilder& builder) {
    Material material = ofType(MaterialType::Diffuse);
    material.colorTexture = material.alphaTexture = builder.texture(noiseTexture(false, true));
    builder.scene().materials[kFloor] = material;
}};
const CaseOfFeature kByteTexelsCase = {floorTexture(&Material::colorTexture, noiseTexture(false))};
const CaseOfFeature kFloatTexelsCase = {floorTexture(&Material::colorTexture, noiseTexture(true))};
const CaseOfFeature kCheckersCase = {
    floorTexture(&Material::colorTexture,
                 {"checker", CheckerTexture{{glm::dvec3(0.2), glm::dvec3(0.9)}}, {8.0, 8.0}}),
    [](Scene& scene) { scene.materials[kFloor].colorTexture = Material::kNoTexture; }};
const CaseOfFeature kFilterCase = {
    camera([](Scene& scene) { scene.film.filter = FilmFilter::BlackmanHarris; })};
const CaseOfFeature kLensCase = {camera([](Scene& scene) {
    scene.camera.lensRadius = 0.1;
    scene.camera.focusDistance = 3.0;
})};
const CaseOfFeature kOrthographicCase = {camera([](Scene& scene) {
    scene.camera.projection = Projection::Orthographic;
    scene.camera.viewHeight = 3.0;
    scene.camera.position = {0.0, 2.0, 2.0};
    scene.camera.forward = {0.0, -0.8, -0.6};
    scene.camera.up = {0.0, 0.6, -0.8};
})};

const FeatureCase kCases[] = {
#define BEGIN_FEATURES
#define FEATURE(id, people) {shared::kFeature##id, #id, k##id##Case.change, k##id##Case.removal},
#define END_FEATURES
#include "shared/feature_table.h"
};

} // namespace

SceneBuilder litFloor() {
    SceneBuilder builder;
    builder.material(0.6, 0.0);
    const uint32_t lamp = builder.material(0.0, 5.0, true);
    builder.rectangle({-3.0, -0.5, 3.0}, {6.0, 0.0, 0.0}, {0.0, 0.0, -6.0}, kFloor);
    builder.rectangle({-1.0, 2.5, -1.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, lamp);
    Scene& scene = builder.scene();
    scene.camera.position = {0.0, 0.3, 3.0};
    scene.camera.verticalFov = 0.8;
    scene.film = {24, 24};
    scene.render = {8, 4, 0};
    return builder;
}

std::span<const FeatureCase> featureCases() { return kCases; }

} // namespace calotype::test
