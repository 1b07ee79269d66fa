#include "read/load.h"

#include <algorithm>

#include "base/lowercase.h"
#include "base/read_file.h"
#include "check/excess_energy.h"
#include "check/radiance_range.h"
#include "read/json/color.h"
#include "read/json/document.h"
#include "read/json/lights.h"
#include "read/json/materials.h"
#include "read/json/override.h"
#include "read/json/settings.h"
#include "read/json/shapes.h"
#include "read/json/textures.h"
#include "read/load_context.h"
#include "read/obj/model_scene.h"

namespace calotype {
namespace {

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
    LoadContext context(options, path);
    nlohmann::json hashed = document;
    if (hashed.is_object())
        hashed.erase("render"); // those are settings, which whoever compares scenes knows apart
    context.hash.add(hashed.dump());
    readScene(
        JsonObject(JsonValue(document, path), {"$schema", "camera", "film", "render", "background",
                                               "textures", "materials", "shapes", "lights"}),
        context);
    return std::move(context).finish();
}

} // namespace calotype
