// The names of MTL files and of materials, as exporters write them.

#include <filesystem>

#include "support/image_files.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

class MtlNamesTest : public testing::Test {
protected:
    static nlohmann::json litMesh() {
        nlohmann::json scene = sceneWithShape(R"({"type": "mesh", "file": "m.obj"})");
        scene["background"] = 1;
        return scene;
    }

    /// The red of the colours of triangles, one for each text behind "usemtl".
    std::vector<double> redsOf(const std::string& mtllib, const std::vector<std::string>& names) {
        std::string text = mtllib + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
        for (const std::string& name : names)
            text += "usemtl " + name + "\nf 1 2 3\n";
        files_.write("m.obj", text);
        scene_ = files_.load(litMesh());
        std::vector<double> reds;
        for (const auto& triangle : std::get<Mesh>(scene_.shapes.at(0).geometry).triangles)
            reds.push_back(scene_.materials.at(triangle.material).color.x);
        return reds;
    }

    SceneFiles files_;
    Scene scene_; ///< the last
};

TEST_F(MtlNamesTest, CommentsBlanksAndQuotesAreNoPartOfThem) {
    files_.write("m.mtl", "\xEF\xBB\xBFnewmtl red # as painted\r\nKd 0.125\r\n"
                          "\tnewmtl\t two words \t\r\nKd 0.25\r\nnewmtl \"quoted\"\r\nKd 0.375\r\n"
                          "newmtl Material #25\r\nKd 0.625\r\nnewmtl Material #26 # top\nKd 0.75\n"
                          "newmtl 50#\nKd 0.875\n");
    const std::vector<std::string> names = {"red",
                                            "red # the body",
                                            "red #",
                                            "\"red\" # the body",
                                            "red\t",
                                            "two words",
                                            "  two words\t # wide",
                                            "\"two words\"",
                                            "quoted",
                                            "Material #25",
                                            "Material #25 # side",
                                            "Material #26",
                                            "50#",
                                            "50# # c"};
    EXPECT_EQ(redsOf("mtllib m.mtl", names),
              (std::vector<double>{0.125, 0.125, 0.125, 0.125, 0.125, 0.25, 0.25, 0.25, 0.375,
                                   0.625, 0.625, 0.75, 0.875, 0.875}));
    EXPECT_TRUE(scene_.warnings.empty());
    EXPECT_EQ(scene_.materials.at(2).name, "m.obj:red # as painted");
}

TEST_F(MtlNamesTest, OnlyACommentIsNoName) {
    files_.write("m.mtl", "newmtl a\nKd 0.25\nnewmtl # nothing\nKd 0.75\n");
    EXPECT_EQ(redsOf("mtllib m.mtl", {"a", "# none", ""}), (std::vector<double>{0.25, 0.5, 0.5}));
    EXPECT_TRUE(scene_.warnings.empty());
}

TEST_F(MtlNamesTest, LibrariesMayHoldBlanksCommentsAndQuotes) {
    files_.write("a.mtl", "newmtl a\nKd 0.25\n");
    files_.write("b c.mtl", "newmtl b\nKd 0.75\n");
    files_.write("d #1.mtl", "newmtl d\nKd 0.125\n");
    const std::vector<double> expected = {0.25, 0.75};
    for (const char* statement :
         {"mtllib a.mtl b c.mtl", "mtllib b c.mtl a.mtl # both", "mtllib \"b c.mtl\" a.mtl",
          "mtllib \"a.mtl\" \"b c.mtl\"\t", "mtllib a.mtl b\\ c.mtl\r", "mtllib A.MTL B C.MTL",
          "mtllib a.mtl\nmtllib b c.mtl #second", "mtllib .\\a.mtl #\nmtllib \"b c.mtl\" # 2"}) {
        EXPECT_EQ(redsOf(statement, {"a", "b"}), expected) << statement;
        EXPECT_TRUE(scene_.warnings.empty()) << statement;
    }
    for (const char* statement :
         {"mtllib d #1.mtl", "mtllib d #1.mtl # the first", "mtllib \"d #1.mtl\""})
        EXPECT_EQ(redsOf(statement, {"d"}), std::vector<double>{0.125}) << statement;
}

TEST_F(MtlNamesTest, LibrariesThatCannotBeReadGiveAWarning) {
    std::filesystem::create_directories(files_.path("folder.mtl"));
    files_.write("a.mtl", "newmtl a\nKd 0.25\n");
    EXPECT_EQ(redsOf("mtllib folder.mtl none.mtl a.mtl", {"a", "b"}),
              (std::vector<double>{0.25, 0.5}));
    ASSERT_EQ(scene_.warnings.size(), 2u);
    EXPECT_NE(scene_.warnings[0].find("cannot read \"folder.mtl\", \"none.mtl\""),
              std::string::npos);
}

// Also under another path, and for another OBJ.
TEST_F(MtlNamesTest, EachLibraryIsReadOnce) {
    files_.write("m.mtl", "newmtl a\nKd 0.25\nKs\n");
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    files_.write("m.obj", "mtllib m.mtl\nmtllib ./m.mtl\nmtllib M.MTL m.mtl\n" + triangle);
    files_.write("n.obj", "mtllib ./m.mtl\n" + triangle);
    nlohmann::json two = litMesh();
    two["shapes"].push_back({{"type", "mesh"}, {"file", "n.obj"}});
    int times = 0;
    LoadOptions options;
    options.onProgress = [&](const std::string& what, double) { times += what == "m.mtl" ? 1 : 0; };
    const Scene scene = files_.load(two, options);
    EXPECT_EQ(times, 1);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("which were ignored: 1 (line 3)"), std::string::npos);
}

// As between files, where the first one that defines a material decides.
TEST_F(MtlNamesTest, TheFirstDefinitionOfAMaterialIsUsed) {
    files_.write("m.mtl", "newmtl a\nKd 0.25\nnewmtl b\nKd 0.5\nnewmtl a\nKd 0.75\nd 0.5\n"
                          "newmtl a\nmap_Kd none.png\nnewmtl c\nKd 0.125\n");
    EXPECT_EQ(redsOf("mtllib m.mtl", {"a", "b", "c"}), (std::vector<double>{0.25, 0.5, 0.125}));
    EXPECT_EQ(scene_.materials.at(1).opacity, 1.0);
    ASSERT_EQ(scene_.warnings.size(), 1u);
    EXPECT_NE(scene_.warnings[0].find("m.mtl: materials that are defined again, of which the first "
                                      "definition is used: 2 (lines 5, 8)"),
              std::string::npos)
        << scene_.warnings[0];
}

TEST_F(MtlNamesTest, TexturesAreLookedForOnceForAllMeshesOfAModel) {
    files_.write("red.png", pngOf({255, 0, 0, 255}));
    std::string mtl;
    std::string obj = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 200; ++i) {
        const std::string name = std::string("m").append(std::to_string(i));
        mtl.append("newmtl ").append(name).append("\nmap_Kd red.png\n");
        obj.append("usemtl ").append(name).append("\nf 1 2 3\n");
    }
    files_.write("m.mtl", mtl);
    files_.write("m.obj", obj);
    nlohmann::json scene = litMesh();
    for (int i = 0; i < 1500; ++i)
        scene["shapes"].push_back(scene["shapes"][0]);
    EXPECT_LT(processorSeconds([&] { files_.load(scene); }), 0.8);
}

TEST_F(MtlNamesTest, TimeIsInProportionToTheInput) {
    constexpr int kMaterials = 2000;
    std::string mtl;
    std::vector<std::string> names;
    std::string libraries;
    for (int i = 0; i < kMaterials; ++i) {
        const std::string number = std::to_string(i);
        mtl.append("newmtl m").append(number).append("\nKd 2 2 2\n"); // each has a remark
        names.emplace_back("m").append(number);
        libraries += "mtllib m.mtl\nmtllib ./m.mtl\n";
    }
    files_.write("m.mtl", mtl);
    EXPECT_LT(processorSeconds([&] { redsOf(libraries, names); }), 1.0); // a tenth by itself
    const std::string blanks(1'000'000, ' ');
    std::string comments = "a";
    for (int i = 0; i < 200'000; ++i)
        comments += " #";
    EXPECT_LT(processorSeconds([&] { redsOf("mtllib m.mtl" + blanks, {"m0", comments}); }), 1.0);
}

} // namespace
} // namespace calotype::test
