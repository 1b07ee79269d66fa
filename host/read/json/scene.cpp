#include "read/json/scene.h"

#include <cstddef>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/read_file.h"
#include "read/json/camera.h"
#include "read/json/color.h"
#include "read/json/document.h"
#include "read/json/film.h"
#include "read/json/json_context.h"
#include "read/json/lights.h"
#include "read/json/materials.h"
#include "read/json/mesh.h"
#include "read/json/object.h"
#include "read/json/override.h"
#include "read/json/schema_text.h"
#include "read/json/shapes.h"
#include "read/json/textures.h"

namespace calotype {
namespace {

const JsonObjectType& sceneObject() {
    static const JsonObjectType type = {
        {
            JsonKey("$schema", textType(),
                    "Where editors find this schema, such as scene.schema.json."),
            JsonKey("camera", cameraType(), "What sees the scene.").required(),
            JsonKey("film", filmType(), "The picture."),
            JsonKey("render", renderType(), "Defaults of options of the command line."),
            JsonKey("background", radianceType(), "A constant radiance from everywhere.")
                .in("W/(m^2 sr)")
                .orElse(0.0),
            JsonKey("textures", texturesType(), "Textures by name."),
            JsonKey("materials", materialsType(), "Materials by name."),
            JsonKey("shapes", arrayType(shapeType()),
                    "Everything that can be seen but the lights."),
            JsonKey("lights", arrayType(lightType()),
                    "Black, opaque shapes that shine from their front."),
        },
        {},
        "Right-handed, +Y up, metres, degrees. Colours are linear Rec. 709. File paths are "
        "relative to the scene file. Comments // and /* */ are accepted, and a text "
        "\"description\" in every object but a mesh's \"materials\"."};
    return type;
}

void readScene(const JsonObject& root, JsonContext& context) {
    Scene& scene = context.scene;
    scene.camera = readCamera(root.required("camera"));
    if (const auto film = root.optional("film"))
        scene.film = readFilm(*film);
    if (const auto render = root.optional("render"))
        scene.render = readRender(*render);
    if (const auto background = root.optional("background"))
        scene.background = readColor(*background, ranges::kRadiance);
    if (const auto shapes = root.optional("shapes"))
        startMeshFiles(*shapes, context);
    if (const auto textures = root.optional("textures")) {
        requireMemoryForTextures(*textures, root.optional("materials"), context);
        readTextures(*textures, context);
    }
    if (const auto materials = root.optional("materials"))
        readMaterials(*materials, context);
    if (const auto shapes = root.optional("shapes"))
        readShapes(*shapes, context);
    if (const auto lights = root.optional("lights")) {
        size_t index = 0;
        for (const JsonValue& light : lights->array())
            scene.shapes.push_back(readLight(light, index++, context));
    }
}

} // namespace

SceneAndNotes readJsonScene(const std::string& path, const LoadOptions& options) {
    const bool isStandardInput = path == "-";
    const std::string name = isStandardInput ? "standard input" : path;
    nlohmann::json document =
        parseJson(isStandardInput ? readStandardInput() : readFile(path, path), name);
    if (document.is_object() && document.contains("asset"))
        throw SceneError(name, "is a glTF file, and not a scene (JSON) or a model (OBJ)");
    for (const SceneOverride& override : options.overrides)
        applyOverride(document, override);
    applyView(document, options.view);
    JsonContext context(options, name);
    if (!isStandardInput)
        context.files.push_back(path);
    nlohmann::json hashed = document;
    if (hashed.is_object())
        hashed.erase("render"); // its settings are compared one by one when films are joined
    context.hash.add(hashed.dump());
    readScene(JsonObject(JsonValue(document, name), sceneObject()), context);
    return std::move(context).finish();
}

std::string sceneSchema() {
    SchemaJson definitions = SchemaJson::object();
    const SchemaJson scene = sceneObject().schema(definitions);
    SchemaJson schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                         {"$id", "https://calotype.invalid/scene-1.schema.json"},
                         {"title", "Calotype scene, version 1"}};
    schema.update(scene);
    schema["definitions"] = definitions;
    return schemaText(schema);
}

} // namespace calotype
