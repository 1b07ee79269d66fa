// No output of any command replaces a file that the command reads, by whatever path or link; and no
// two processes write one file.
#include <csignal>
#include <filesystem>

#include "cli/film_cli_test.h"
#include "image/png.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

/// A model with an MTL file and a texture, and a scene with both.
class OutputsTest : public FilmTest {
protected:
    OutputsTest() {
        Rgb8Image image(2, 2);
        writePng(texture_, image);
        folder_.write("chair.mtl", "newmtl wood\nmap_Kd chair.png\n");
        folder_.write("chair.obj", "mtllib chair.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                   "vt 0 0\nvt 1 0\nvt 0 1\nusemtl wood\nf 1/1 2/2 3/3\n");
        std::string scene = kSmallScene;
        const std::string shapes = "\"shapes\": [";
        scene.replace(scene.find(shapes), shapes.size(),
                      shapes + R"({ "type": "mesh", "file": "chair.obj" },)");
        withModel_ = folder_.write("model.json", scene);
    }

    /// Expects that the command is refused, and that no file is changed or made.
    void expectRefused(const std::vector<std::string>& arguments, const std::string& input) {
        SCOPED_TRACE(arguments.front() + " " + arguments.back());
        const std::vector<std::string> names = folder_.names();
        const std::string before = readText(input);
        expectFailure(runProgram(arguments), 2, "is read by this command");
        EXPECT_TRUE(readText(input) == before) << input;
        EXPECT_EQ(folder_.names(), names);
    }

    const std::string texture_ = folder_ / "chair.png";
    std::string withModel_;
};

TEST_F(OutputsTest, RenderReplacesNothingThatItReads) {
    const std::string out = folder_ / "out.png";
    for (const std::string& scene : {folder_ / "chair.obj", withModel_}) {
        expectRefused({"render", scene, "-o", texture_}, texture_);
        expectRefused({"render", scene, "-o", out, "--stats", folder_ / "chair.mtl"},
                      folder_ / "chair.mtl");
        expectRefused({"render", scene, "-o", out, "--stats", scene}, scene);
        expectRefused({"render", scene, "-o", out, "--preview-every", "1", "--preview-file",
                       folder_ / "./chair.png"},
                      texture_);
    }
    expectRefused({"render", withModel_, "-o", out, "--stats", folder_ / "chair.obj"},
                  folder_ / "chair.obj");
    const std::string a = film("a.film", {"--spp", "16"});
    expectRefused({"render", scene_, "--resume", a, "--film", folder_ / "b", "--stats", a}, a);
    fs::create_hard_link(a, folder_ / "linked.film");
    expectRefused({"render", scene_, "-o", out, "--film", folder_ / "b.film", "--resume", a,
                   "--stats", folder_ / "linked.film"},
                  a);
}

TEST_F(OutputsTest, LinksLeadToTheSameFile) {
    fs::create_directory(folder_ / "other");
    fs::create_directory_symlink(folder_.path(), folder_.path() / "other/back");
    fs::create_symlink("chair.png", folder_ / "symbolic.png");
    fs::create_hard_link(texture_, folder_ / "hard.png");
    for (const char* name :
         {"symbolic.png", "hard.png", "other/back/chair.png", "other/../chair.png"})
        expectRefused({"render", withModel_, "-o", folder_ / name}, texture_);
    EXPECT_TRUE(fs::is_symlink(folder_ / "symbolic.png"));
    // The scene may be read by a link, too.
    fs::create_symlink("model.json", folder_ / "link.json");
    expectRefused({"render", folder_ / "link.json", "-o", folder_ / "a.png", "--stats", withModel_},
                  withModel_);
    // Two outputs that are one file, which need not exist.
    fs::create_symlink("new.png", folder_ / "to-new.png");
    expectFailure(
        runProgram({"render", scene_, "-o", folder_ / "new.png", "-o", folder_ / "to-new.png"}), 2,
        "given twice");
}

TEST_F(OutputsTest, MergeAndCompareReplaceNothingThatTheyRead) {
    const std::string a = film("a.film", {"--samples", "0:16"});
    const std::string b = film("b.film", {"--samples", "16:32"});
    expectRefused({"merge", a, b, "-o", b}, b);
    fs::create_hard_link(b, folder_ / "c.film");
    expectRefused({"merge", a, b, "-o", folder_ / "new.png", "-o", folder_ / "c.film"}, b);
    fs::copy(texture_, folder_ / "b.png");
    expectRefused({"compare", texture_, folder_ / "b.png", "--diff", folder_ / "b.png"},
                  folder_ / "b.png");
    fs::create_symlink("chair.png", folder_ / "symbolic.png");
    expectRefused({"compare", texture_, folder_ / "b.png", "--diff", folder_ / "symbolic.png"},
                  texture_);
}

// What a study or a bench reads is known before either measures.
TEST_F(OutputsTest, StudyAndBenchReplaceNothingThatTheyRead) {
    fs::copy(folder_ / "model.json", folder_ / "study.html");
    expectRefused({"study", folder_ / "study.html", "-o", folder_.path(), "-q"},
                  folder_ / "study.html");
    expectRefused({"bench", scene_, withModel_, "--json", texture_}, texture_);
    expectRefused({"bench", scene_, withModel_, "--json", withModel_}, withModel_);
}

TEST_F(OutputsTest, TwoProcessesDoNotWriteOneFile) {
    const std::string path = folder_ / "a.film";
    fs::create_symlink("a.film", folder_ / "link.film");
    bool isTried = false;
    ProgramOptions options;
    options.whileRunning = [&](int pid, double) {
        if (isTried || !fs::exists(path))
            return;
        isTried = true;
        for (const char* name : {"a.film", "link.film"})
            expectFailure(runProgram(render({"--film", folder_ / name})), 7,
                          std::string(name).append("' is being written by process ") +
                              std::to_string(pid));
        const std::string picture = folder_ / "a.png";
        expectFailure(runProgram(render({"-o", picture})), 7, "a.png' is being written by");
        EXPECT_EQ(runProgram(render({"-o", folder_ / "b.png"})).exitCode, 0);
        kill(pid, SIGTERM);
    };
    const ProgramResult result =
        runProgram(render({"--film", path, "-o", folder_ / "a.png", "--spp", "1000000"}), options);
    EXPECT_EQ(result.exitCode, 1) << result.errors;
    EXPECT_TRUE(isTried);
    EXPECT_EQ(runProgram(render({"--film", path, "--spp", "16"})).exitCode, 0);
    for (const std::string& name : folder_.names())
        EXPECT_EQ(name.find(".calotype-"), std::string::npos) << name;
}

} // namespace
} // namespace calotype::test
