// What each feature of the kernel costs: a scene that does without, rendered by a kernel that lacks
// the feature, by one that has it, and the scene with something that uses it. Prints a table:
// frames a second of the first, and what the others make of it, medians over rounds of all three.
// usage: bench_features [ROUNDS]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "engine/bench.h"
#include "support/feature_cases.h"
#include "support/render_scene.h"

namespace {

using namespace calotype;
using namespace calotype::test;

/// What a scene of triangles alone cannot show: a metal ball under a ball that shines.
SceneBuilder litBall() {
    SceneBuilder builder;
    Material metal;
    metal.type = MaterialType::Metal;
    metal.roughness = 0.3;
    builder.scene() = litFloor().scene();
    builder.scene().shapes.clear();
    builder.scene().materials = {metal, metal};
    builder.scene().materials[1].emission = glm::dvec3(5.0);
    builder.add(makeShape(Sphere{{}, 0.6}, 0));
    builder.add(makeShape(Sphere{{glm::dmat3(1.0), {0.0, 2.5, 0.0}}, 0.5}, 1));
    return builder;
}

void addRectangle(SceneBuilder& builder, uint32_t material) {
    builder.rectangle({-3.0, -0.7, 3.0}, {6.0, 0.0, 0.0}, {0.0, 0.0, -6.0}, material);
}

/// The lit floor with its lamp cut into 64 rectangles, whose triangles are each chosen too rarely
/// to be sampled by solid angle.
SceneBuilder floorBelowManyLamps() {
    SceneBuilder builder = litFloor();
    const uint32_t lamp =
        std::get<Mesh>(builder.scene().shapes.back().geometry).triangles[0].material;
    builder.scene().shapes.pop_back();
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            builder.rectangle({-1.0 + 0.25 * i, 2.5, -1.0 + 0.25 * j}, {0.25, 0.0, 0.0},
                              {0.0, 0.0, 0.25}, lamp);
    return builder;
}

struct Row {
    uint32_t feature;
    Scene without;
    Scene with;
};

/// The scene with as little changed as takes the feature from it; nothing where that is the lit
/// floor.
std::optional<Scene> without(uint32_t feature, Scene scene) {
    switch (feature) {
    case shared::kFeatureGgx:
    case shared::kFeatureMirrors:
    case shared::kFeatureBlinnPhong:
    case shared::kFeatureDielectric:
        for (Material& material : scene.materials)
            material.type = MaterialType::Diffuse;
        return scene;
    case shared::kFeatureSphereLights:
    case shared::kFeatureCylinderLights:
    case shared::kFeatureConeLights:
    case shared::kFeatureDiskLights:
        scene.materials.back().emission = glm::dvec3(0.0);
        return scene;
    case shared::kFeatureManyQuadrics: // one small ball instead
        scene.shapes.resize(litFloor().scene().shapes.size() + 1);
        std::get<Sphere>(scene.shapes.back().geometry).radius = 0.1;
        return scene;
    case shared::kFeatureHiddenLights:
        for (Material& material : scene.materials)
            material.visibleToCamera = true;
        return scene;
    case shared::kFeatureOrthographic:
        scene.camera.projection = Projection::Perspective;
        return scene;
    default:
        return std::nullopt;
    }
}

Row rowOf(uint32_t feature, SceneBuilder base, const SceneChange& change) {
    const Scene unchanged = base.scene();
    change(base);
    return {feature, without(feature, base.scene()).value_or(unchanged), base.scene()};
}

/// A row for each feature, the lit floor's own ones beside the lit ball.
std::vector<Row> rows() {
    std::vector<Row> rows = {
        rowOf(shared::kFeatureTriangles, litBall(), [](SceneBuilder& b) { addRectangle(b, 0); }),
        rowOf(shared::kFeatureTriangleLights, litBall(),
              [](SceneBuilder& b) { addRectangle(b, 1); }),
        {shared::kFeatureSolidAngleLights, floorBelowManyLamps().scene(), litFloor().scene()},
        rowOf(shared::kFeatureDiffuse, litBall(),
              [](SceneBuilder& b) { b.scene().materials[0].type = MaterialType::Diffuse; })};
    const auto isThere = [&](uint32_t feature) {
        return std::ranges::any_of(rows, [&](const Row& row) { return row.feature == feature; });
    };
    for (const FeatureCase& featureCase : featureCases())
        if (!isThere(featureCase.feature))
            rows.push_back(rowOf(featureCase.feature, litFloor(), featureCase.change));
    std::ranges::sort(rows, {}, &Row::feature);
    return rows;
}

struct Frames {
    SceneFeatures needed;
    double perSecond;
};

Frames render(const Scene& scene, const std::optional<SceneFeatures>& features = std::nullopt) {
    RenderWish wish;
    wish.width = 256;
    wish.height = 256;
    wish.samplesPerPixel = 16;
    wish.features = features;
    const RenderedScene rendered = renderScene(scene, wish);
    return {rendered.needed, 1.0 / rendered.totals.seconds};
}

void printRow(const Row& row, int rounds) {
    std::vector<double> out, unused, used; // frames a second; then relative to the round's first
    for (int round = 0; round < rounds; ++round) {
        const Frames without = render(row.without);
        SceneFeatures features = without.needed;
        features.enabled[row.feature] = true;
        out.push_back(without.perSecond);
        unused.push_back(render(row.without, features).perSecond / without.perSecond);
        used.push_back(render(row.with).perSecond / without.perSecond);
    }
    std::printf("| %s | %.1f | %.2f | %.2f |\n", std::string(kFeatureNames[row.feature]).c_str(),
                spreadOf(out).median, spreadOf(unused).median, spreadOf(used).median);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 5;
    std::printf("| feature | compiled out | in, unused | in, used |\n|---|---|---|---|\n");
    for (const Row& row : rows())
        printRow(row, std::max(rounds, 1));
}
