// Warnings of glass whose faces are wound inward, and no false ones.

#include <string>
#include <utility>
#include <vector>

#include "unit/scene_files.h"

namespace calotype::test {
namespace {

enum class Wound { Outward, Inward, OneFaceInward, OpenOutward, OpenInward };

/// A cube as an OBJ, with vertices of its own: half its side, and the x of its centre.
std::string cube(double half, Wound wound = Wound::Outward, double x = 0.0) {
    // Corner i is at -half or half by its bits 0 (x), 1 (y) and 2 (z).
    static constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    std::string text;
    for (int i = 0; i < 8; ++i) {
        text += "v " + std::to_string(x + (i & 1 ? half : -half)) + " " +
                std::to_string(i & 2 ? half : -half) + " " + std::to_string(i & 4 ? half : -half) +
                "\n";
    }
    const bool isOpen = wound == Wound::OpenOutward || wound == Wound::OpenInward;
    for (int side = isOpen ? 1 : 0; side < 6; ++side) {
        const bool isInward = wound == Wound::Inward || wound == Wound::OpenInward ||
                              (wound == Wound::OneFaceInward && side == 5);
        text += "f";
        for (int k = 0; k < 4; ++k)
            text += " " + std::to_string(kSides[side][isInward ? 3 - k : k] - 8);
        text += "\n";
    }
    return text;
}

class WindingTest : public testing::Test {
protected:
    /// Those about winding, of a scene with one mesh for each OBJ, of the material `glass`.
    std::vector<std::string> warningsOf(const std::vector<std::string>& objs,
                                        const std::string& furtherShape = "",
                                        const std::string& transform = "{}") {
        nlohmann::json scene = plainScene();
        scene["materials"]["glass"] = nlohmann::json::parse(glass_);
        scene["background"] = 1;
        for (size_t i = 0; i < objs.size(); ++i) {
            const std::string name = "m" + std::to_string(i) + ".obj";
            files_.write(name, objs[i]);
            scene["shapes"].push_back({{"type", "mesh"}, {"file", name}, {"material", "glass"}});
            scene["shapes"].back()["transform"] = nlohmann::json::parse(transform);
        }
        if (!furtherShape.empty())
            scene["shapes"].push_back(nlohmann::json::parse(furtherShape));
        std::vector<std::string> warnings = files_.load(scene).warnings;
        std::erase_if(warnings, [](const std::string& warning) {
            return warning.find("wound") == std::string::npos;
        });
        return warnings;
    }

    void expectWarning(const std::vector<std::string>& warnings, const std::string& fragment) {
        ASSERT_EQ(warnings.size(), 1u) << fragment;
        EXPECT_NE(warnings[0].find(fragment), std::string::npos) << warnings[0];
    }

    SceneFiles files_;
    std::string glass_ = R"({"type": "dielectric", "ior": 1.5})";
};

TEST_F(WindingTest, GlassWoundInwardIsNamedWithItsFile) {
    EXPECT_TRUE(warningsOf({cube(1.0)}).empty());
    const auto warnings = warningsOf({cube(1.0, Wound::Inward)});
    expectWarning(warnings, "/shapes/0: the material \"glass\" is on a closed part of \"m0.obj\" "
                            "that is wound inward");
    expectWarning(warnings, "reverse the order of the corners of the faces");
}

TEST_F(WindingTest, MirroringTransformsChangeNothing) {
    const std::string mirror = R"({"scale": [-1, 1, 2], "translate": [1e5, 0, 3]})";
    EXPECT_TRUE(warningsOf({cube(1.0)}, "", mirror).empty());
    expectWarning(warningsOf({cube(1.0, Wound::Inward)}, "", mirror), "wound inward");
}

TEST_F(WindingTest, HollowGlassIsRight) {
    const std::string hollow = cube(1.0) + cube(0.9, Wound::Inward);
    EXPECT_TRUE(warningsOf({hollow}).empty());
    EXPECT_TRUE(warningsOf({cube(1.0), cube(0.9, Wound::Inward)}).empty()) << "two meshes";
    EXPECT_TRUE(warningsOf({cube(0.9, Wound::Inward), cube(1.0)}).empty()) << "the inner first";
    EXPECT_TRUE(warningsOf({hollow + cube(0.5)}).empty()) << "with a marble in it";
    EXPECT_TRUE(warningsOf({hollow + cube(0.5) + cube(0.4, Wound::Inward)}).empty());
    EXPECT_TRUE(
        warningsOf({cube(1.0) + cube(0.3, Wound::Inward, -0.5) + cube(0.3, Wound::Inward, 0.5)})
            .empty())
        << "two bubbles";
    EXPECT_TRUE(warningsOf({cube(1.0, Wound::OpenOutward) + cube(0.5, Wound::Inward)}).empty())
        << "in glass with a hole";
}

TEST_F(WindingTest, BubblesInQuadricsAreRight) {
    const auto inside = [&](const std::string& shape) {
        return warningsOf({cube(0.2, Wound::Inward)},
                          R"({"material": "glass", "type": )" + shape + "}");
    };
    EXPECT_TRUE(inside(R"("sphere", "radius": 1)").empty());
    EXPECT_TRUE(inside(R"("cylinder", "radius": 1, "height": 2)").empty());
    EXPECT_TRUE(inside(R"("cone", "apex": [0, 1, 0], "height": -2, "slope": 1)").empty());
    EXPECT_EQ(inside(R"("sphere", "radius": 1, "center": [3, 0, 0])").size(), 1u);
    EXPECT_EQ(inside(R"("cylinder", "radius": 1, "height": 2, "center": [0, 3, 0])").size(), 1u);
    EXPECT_EQ(inside(R"("cone", "apex": [0, -1, 0], "height": -2, "slope": 1)").size(), 1u);
    EXPECT_EQ(warningsOf({cube(0.2, Wound::Inward)},
                         R"({"material": "wall", "type": "sphere", "radius": 1})")
                  .size(),
              1u)
        << "in a solid that is not glass";
}

TEST_F(WindingTest, PartsThatAreInNoGlassAreWrong) {
    expectWarning(warningsOf({cube(1.0, Wound::Inward) + cube(0.9)}), "on a closed part");
    expectWarning(warningsOf({cube(1.0) + cube(0.9, Wound::Inward) + cube(0.5, Wound::Inward)}),
                  "on a closed part of");
    expectWarning(warningsOf({cube(1.0) + cube(0.9, Wound::Inward, 3.0)}), "on a closed part of");
    expectWarning(warningsOf({cube(1.0, Wound::Inward, 0.0) + cube(1.0, Wound::Inward, 3.0) +
                              cube(1.0, Wound::Inward, 6.0) + cube(1.0, Wound::Outward, 9.0)}),
                  "on 3 closed parts of \"m0.obj\" that are wound inward");
    expectWarning(warningsOf({cube(1.0, Wound::Inward), cube(1.0, Wound::Inward, 3.0)}),
                  "(and 1 more of this kind, at ");
}

// One cube written with vertices of its own for every side.
TEST_F(WindingTest, SplitVerticesAreJoined) {
    std::string split;
    for (int side = 0; side < 6; ++side)
        split += cube(1.0, Wound::Inward);
    std::string text;
    size_t face = 0;
    for (size_t at = 0; at < split.size(); at = split.find('\n', at) + 1) {
        const std::string line = split.substr(at, split.find('\n', at) - at);
        if (line[0] == 'v' || face++ % 7 == 0) // the next side of each copy
            text += line + "\n";
    }
    expectWarning(warningsOf({text}), "on a closed part of");
}

TEST_F(WindingTest, FacesWoundBothWaysAreWrong) {
    expectWarning(warningsOf({cube(1.0, Wound::OneFaceInward)}),
                  "has faces wound inward beside faces wound outward");
}

TEST_F(WindingTest, OtherSurfacesAreNotJudged) {
    EXPECT_TRUE(warningsOf({cube(1.0, Wound::OpenInward)}).empty()) << "wound inward, but open";
    EXPECT_TRUE(warningsOf({"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n"}).empty())
        << "two sides of a sheet";
    // Glass, liquid and air, with one sheet between each two: a wall across the cube.
    EXPECT_TRUE(warningsOf({cube(1.0, Wound::Inward) + "f 1 2 8 7\n"}).empty())
        << "a third sheet at some edges";
    glass_ = R"({"type": "dielectric", "ior": 1, "exterior_ior": 1.5})";
    EXPECT_TRUE(warningsOf({cube(1.0, Wound::Inward)}).empty()) << "the enclosed space is glass";
    glass_ = R"({"type": "dielectric", "ior": 1.5, "exterior_ior": 1.5})";
    EXPECT_TRUE(warningsOf({cube(1.0, Wound::Inward)}).empty()) << "no boundary at all";
    glass_ = R"({"type": "diffuse", "color": 0.5})";
    EXPECT_TRUE(warningsOf({cube(1.0, Wound::Inward)}).empty()) << "opaque";
}

TEST_F(WindingTest, BareModelsAreJudgedToo) {
    files_.write("m.mtl", "newmtl g\nKd 0 0 0\nillum 6\nNi 1.5\nd 0.1\n");
    const std::string path =
        files_.write("m.obj", "mtllib m.mtl\nusemtl g\n" + cube(1.0, Wound::Inward));
    const Scene scene = loadScene(path);
    size_t count = 0;
    for (const std::string& warning : scene.warnings)
        count += warning.find("m.obj\" that is wound inward") != std::string::npos ? 1 : 0;
    EXPECT_EQ(count, 1u);
}

} // namespace
} // namespace calotype::test
