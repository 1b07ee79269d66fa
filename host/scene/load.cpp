#include "scene/load.h"

#include <algorithm>

#include "base/lowercase.h"
#include "base/read_file.h"
#include "scene/energy_warnings.h"
#include "scene/json_document.h"
#include "scene/limit_warnings.h"
#include "scene/load_context.h"
#include "scene/model_scene.h"
#include "scene/radiance_range.h"
#include "scene/read_color.h"
#include "scene/read_lights.h"
#include "scene/read_materials.h"
#include "scene/read_settings.h"
#include "scene/read_shapes.h"
#include "scene/read_textures.h"
#include "scene/scene_override.h"

namespace calotype {
namespace {

bool emits(const Scene& scene, uint32_t material) {
    return scene.materials[material].emission != glm::dvec3(0.0);
}

bool hasEmission(const Scene& scene) {
    return std::ranges::any_of(scene.shapes, [&](const Shape& shape) {
        if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
            return std::ranges::any_of(mesh->triangles,
                                       [&](const auto& t) { return emits(scene, t.material); });
        }
        return emits(scene, shape.material);
    });
}

void warnIfBlack(LoadContext& context, const std::string& path) {
    if (context.scene.background != glm::dvec3(0.0)) {
        return;
    }
    if (context.scene.shapes.empty()) {
        context.warn(path, "there are no shapes and no lights, so the picture will be black");
    } else if (!hasEmission(context.scene)) {
        context.warn(path, "nothing emits light, so the picture will be black");
    }
}

void readScene(const JsonObject& root, LoadContext& context) {
    if (const auto schema = root.optional("$schema")) {
        schema->text();
    }
    Scene& scene = context.scene;
    scene.camera = readCamera(root.required("camera"));
    if (const auto film = root.optional("film")) {
        scene.film = readFilm(*film);
    }
    if (const auto render = root.optional("render")) {
        scene.render = readRender(*render);
    }
    if (const auto background = root.optional("background")) {
        scene.background = readRadiance(*background);
    }
    if (const auto textures = root.optional("textures")) {
        readTextures(*textures, context);
    }
    if (const auto materials = root.optional("materials")) {
        readMaterials(*materials, context);
    }
    if (const auto shapes = root.optional("shapes")) {
        for (const JsonValue& shape : shapes->array()) {
            scene.shapes.push_back(readShape(shape, context));
        }
    }
    if (const auto lights = root.optional("lights")) {
        size_t index = 0;
        for (const JsonValue& light : lights->array()) {
            scene.shapes.push_back(readLight(light, index++, context));
        }
    }
}

/// Whether the name ends in ".obj", in any case.
bool isModel(const std::string& path) {
    return lowercase(std::filesystem::path(path).extension().string()) == ".obj";
}

} // namespace

Scene loadScene(const std::string& path, const LoadOptions& options) {
    if (isModel(path)) {
        return loadModelScene(path, options);
    }
    nlohmann::json document = parseJson(readFile(path, path), path);
    for (const SceneOverride& override : options.overrides) {
        applyOverride(document, override);
    }
    LoadContext context(options, std::filesystem::path(path).parent_path());
    nlohmann::json hashed = document;
    if (hashed.is_object())
        hashed.erase("render"); // those are settings, which whoever compares scenes knows apart
    context.hash.add(hashed.dump());
    readScene(
        JsonObject(JsonValue(document, path), {"$schema", "camera", "film", "render", "background",
                                               "textures", "materials", "shapes", "lights"}),
        context);
    context.resizeFilm();
    requireRadianceInRange(context.scene, path);
    warnOfExcessEnergy(context);
    warnOfLimits(context, path);
    warnIfBlack(context, path);
    context.scene.hash = context.hash.value();
    return std::move(context.scene);
}

} // namespace calotype
