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
        files_.write("m.mtl", "newmtl a\n" + statements);
        return files_.load(sceneWithShape(R"({"type": "mesh", "file": "m.obj"})"), options);
    }

    /// Its material, where no warning but that of a black picture is due.
    Material materialOf(const std::string& statements) {
        const Scene scene = load(statements);
        for (const std::string& warning : scene.warnings)
            EXPECT_NE(warning.find("the picture will be black"), std::string::npos) << warning;
        return scene.materials.at(1);
    }

    /// Its material, where a warning that contains `remark` is due.
    Material remarkedMaterialOf(const std::string& statements, const std::string& remark) {
        const Scene scene = load(statements);
        const bool found = std::ranges::any_of(scene.warnings, [&](const std::string& warning) {
            return warning.find("m.obj: " + remark) != std::string::npos;
        });
        EXPECT_TRUE(found) << "no warning says: " << remark;
        return scene.materials.at(1);
    }

    SceneError errorOfLoading(const std::string& statements) {
        return errorOf([&] { load(statements); });
    }

    SceneFiles files_;
};

} // namespace calotype::test
