#pragma once

#include <memory>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "read/json/json_context.h"
#include "read/json/materials.h"
#include "read/json/shapes.h"
#include "scene_files.h"

namespace calotype::test {

/// What the readers share, filled by hand: textures "opaque" and "holes" (images, the second
/// transparent, of one texel of half grey) and "tiles" (a checker of 0 and 1).
class JsonContextFixture {
public:
    JsonContextFixture() {
        addImage("holes", true);
        addImage("opaque", false);
        context.addTexture({"tiles", CheckerTexture{{glm::dvec3(0.0), glm::dvec3(1.0)}}});
        context.textureNames.push_back("tiles");
    }

    /// Reads `materials`, JSON of materials by name.
    void readMaterialsFrom(const std::string& materials) {
        json_ = nlohmann::json::parse(materials);
        readMaterials(JsonValue(json_, file_, "/materials"), context);
    }

    /// Reads one of "shapes", the first.
    Shape readShape(const std::string& shape) {
        readShapes(value("[" + shape + "]", "/shapes"), context);
        return std::move(context.scene.shapes.back());
    }

    /// A value at `pointer` of the file "scene.json".
    JsonValue value(const std::string& text, const std::string& pointer) {
        json_ = nlohmann::json::parse(text);
        return {json_, file_, pointer};
    }

    const LoadOptions options;
    SceneFiles files;
    JsonContext context{options, files.path("scene.json")};

    static constexpr uint32_t kHoles = 0;
    static constexpr uint32_t kOpaque = 1;
    static constexpr uint32_t kTiles = 2;

private:
    void addImage(const std::string& name, bool isTransparent) {
        const uint8_t alpha = isTransparent ? 0 : 255;
        const TexelImage texel{1, 1, {128, 128, 128, alpha}, {}, true, isTransparent};
        context.addTexture({name, ImageTexture{std::make_shared<const TexelImage>(texel)}});
        context.textureNames.push_back(name);
    }

    const std::string file_ = "/scene.json"; ///< the form in which expectError takes a place
    nlohmann::json json_;
};

} // namespace calotype::test
