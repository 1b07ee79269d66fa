#pragma once

#include <algorithm>
#include <string>

#include "support/image_files.h"
#include "unit/scene_files.h"

namespace calotype::test {

/// A mesh of one triangle whose material is that of an MTL file.
class MtlFixture : public testing::Test {
protected:
    MtlFixture() {
        files_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                              "usemtl a\nf 1/1 2/2 3/3\n");
        files_.write("red.png", pngOf({255, 0, 0, 255}));
        files_.write("leaf.png", pngOf({0, 255, 0, 100}));
        files_.write("grey.png", pngOf({60, 60, 60, 255}));
        files_.write("normals.png", pngOf({128, 128, 255, 255}));
    }

    /// Loads a mesh whose only material has these statements.
    Scene load(const std::string& statements, const LoadOptions& options = {}) {
        files_.write("m.mtl", firstLine_ + "newmtl a\n" + statements);
        return files_.load(sceneWithShape(R"({"type": "mesh", "file": "m.obj"})"), options);
    }

    /// Its material, where no warning but that of a black picture is due.
    Material materialOf(const std::string& statements) {
        const Scene scene = load(statements);
        for (const std::string& warning : scene.warnings)
            EXPECT_NE(warning.find("the picture will be black"), std::string::npos) << warning;
        return scene.materials.at(1);
    }

    /// Its material, where a warning about the OBJ or the MTL that starts with `remark` is due.
    Material remarkedMaterialOf(const std::string& statements, const std::string& remark) {
        const Scene scene = load(statements);
        EXPECT_TRUE(hasWarning(scene, "m.obj: " + remark) || hasWarning(scene, "m.mtl: " + remark))
            << "no warning says: " << remark;
        return scene.materials.at(1);
    }

    static bool hasWarning(const Scene& scene, const std::string& fragment) {
        return std::ranges::any_of(scene.warnings, [&](const std::string& warning) {
            return warning.find(fragment) != std::string::npos;
        });
    }

    SceneError errorOfLoading(const std::string& statements) {
        return errorOf([&] { load(statements); });
    }

    std::string firstLine_; ///< of the MTL file, with its line end
    SceneFiles files_;
};

} // namespace calotype::test
