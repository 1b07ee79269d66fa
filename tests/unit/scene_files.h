#pragma once

#include <ctime>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "read/load.h"
#include "support/scratch_folder.h"

namespace calotype::test {

/// A folder of its own for the files of one test.
class SceneFiles {
public:
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    std::string write(const std::string& name, const std::string& text) const {
        writeBytes(folder_ / name, text);
        return path(name);
    }

    Scene loadText(const std::string& text, const LoadOptions& options = {}) const {
        return loadScene(write("scene.json", text), options);
    }
    Scene load(const nlohmann::json& scene, const LoadOptions& options = {}) const {
        return loadText(scene.dump(), options);
    }

private:
    ScratchFolder folder_;
};

/// The SceneError that `action` throws; a failure of the test and an empty one if it throws none.
template <typename Action>
SceneError errorOf(Action&& action) {
    try {
        action();
    } catch (const SceneError& error) {
        return error;
    }
    ADD_FAILURE() << "no SceneError was thrown";
    return {"", ""};
}

/// Processor time that `action` takes, which other programs' load does not change.
template <typename Action>
double processorSeconds(Action&& action) {
    const std::clock_t start = std::clock();
    action();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Expects `error` at "DIRECTORY/where" (the file's own name and what follows) and a message that
/// contains `fragment`.
inline void expectError(const SceneError& error, const std::string& where,
                        const std::string& fragment) {
    EXPECT_TRUE(error.where().ends_with("/" + where)) << error.what() << "\nis not at " << where;
    EXPECT_NE(std::string(error.what()).find(fragment, error.where().size()), std::string::npos)
        << error.what() << "\ndoes not say: " << fragment;
}

/// A scene with a camera and a material "wall", for tests to add to.
inline nlohmann::json plainScene() {
    return nlohmann::json::parse(R"({
        "camera": {"position": [0, 1, 4], "target": [0, 1, 0]},
        "materials": {"wall": {"type": "diffuse", "color": 0.5}},
        "shapes": [],
        "lights": []
    })");
}

/// plainScene with one more shape.
inline nlohmann::json sceneWithShape(const std::string& shape) {
    nlohmann::json scene = plainScene();
    scene["shapes"].push_back(nlohmann::json::parse(shape));
    return scene;
}

inline nlohmann::json sceneWithLight(const std::string& light) {
    nlohmann::json scene = plainScene();
    scene["lights"].push_back(nlohmann::json::parse(light));
    return scene;
}

} // namespace calotype::test
