// Texture statements of MTL files: file names and options.

#include <gtest/gtest.h>

#include "read/obj/mtl_texture.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

MtlTexture parse(const std::string& text) { return parseMtlTexture(text, "m.mtl:3").value(); }

TEST(MtlTextureTest, FindsTheName) {
    for (const auto& [text, file] : std::vector<std::pair<std::string, std::string>>{
             {"a.png", "a.png"},
             {"my own wood 2.png  ", "my own wood 2.png"},
             {"..\\maps\\a b.png", "..\\maps\\a b.png"},
             {"\"a b.png\"", "a b.png"},
             {"wood #2.png", "wood #2.png"},
             {"-bm 1.5 a.png", "a.png"},
             {"-s 1 1 1 -o 0 0 0 -mm 0 1 my wood.png", "my wood.png"},
             {"-o 0.1 diffuse.jpg", "diffuse.jpg"},
             {"-o 1 2 3 4.png", "4.png"},
             {"-s 2 512", "512"},
             {"-texres 512 a.png", "a.png"},
             {"-type cube_front bump.jpg", "bump.jpg"},
             {"-imfchan r bumpmap2.jpg -bm 1.5", "bumpmap2.jpg"},
             {"-clamp on a b -clamp off -s 2 3", "a b"},
             {"-colorspace sRGB -o 0.1 diffuse.jpg", "diffuse.jpg"},
             {"-blendu on -blendv off -boost 2 -cc on -t 1 1 1 a.png", "a.png"},
             {"wood -bm 2.png", "wood -bm 2.png"},
             {"wood -old.png", "wood -old.png"},
             {"wood -old -bm 2", "wood -old"},
             {"wood -s x -o 1 2", "wood -s x"},
             {"-wood.png", "-wood.png"},
             {"wood - copy.png", "wood - copy.png"}}) {
        EXPECT_EQ(parse(text).file, file) << text;
    }
    for (const char* text : {"", "  ", "-bm 2", "\"\""})
        EXPECT_FALSE(parseMtlTexture(text, "m.mtl:3").has_value()) << text;
}

TEST(MtlTextureTest, ReadsTheOptions) {
    const MtlTexture all = parse("-s 2 3 4 -o 0.5 -0.25 -bm 0.3 -clamp on -imfchan g a.png");
    EXPECT_EQ(all.scale, glm::dvec2(2.0, 3.0));
    EXPECT_EQ(all.offset, glm::dvec2(0.5, -0.25));
    EXPECT_EQ(all.bumpMultiplier, 0.3);
    EXPECT_TRUE(all.clamps);
    EXPECT_EQ(all.channel, TexelChannel::Green);
    EXPECT_EQ(all.place, "m.mtl:3");
    EXPECT_TRUE(all.ignored.empty());
    const MtlTexture none = parse("a.png");
    EXPECT_EQ(none.scale, glm::dvec2(1.0));
    EXPECT_EQ(none.bumpMultiplier, 1.0);
    EXPECT_FALSE(none.clamps);
    EXPECT_FALSE(none.channel.has_value());
    EXPECT_FALSE(none.isLinear);
    EXPECT_EQ(parse("-s 2 a.png").scale, glm::dvec2(2.0, 1.0));
    EXPECT_EQ(parse("-o 2 a.png").offset, glm::dvec2(2.0, 0.0));
    EXPECT_EQ(parse("a.png -bm 4").bumpMultiplier, 4.0);
    EXPECT_EQ(parse("-imfchan m a.png").channel, TexelChannel::Alpha);
    EXPECT_EQ(parse("-imfchan l a.png").channel, TexelChannel::Luminance);
    EXPECT_TRUE(parse("-colorspace linear a.png").isLinear);
}

TEST(MtlTextureTest, ListsOptionsThatAreIgnoredButMatter) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(parse("-mm 0 0.5 -t 1 -type sphere -boost 2 -cc on -blendu off a.png").ignored,
              (Names{"-mm", "-t", "-type", "-boost", "-cc", "-blendu"}));
    EXPECT_EQ(parse("-mm 0 1 -t 0 0 0 -boost 0 -cc off -blendu on -texres 64 a.png").ignored,
              Names{});
    EXPECT_EQ(parse("-mm 0.5 1 -imfchan z a.png").ignored, (Names{"-mm", "-imfchan"}));
}

TEST(MtlTextureTest, RefusesGarbageInOptions) {
    for (const char* text : {"-bm x a.png", "-bm", "-s nan a.png", "-o a.png", "-clamp yes a.png",
                             "-mm 0 a.png", "-boost inf a.png"}) {
        EXPECT_EQ(errorOf([&] { parse(text); }).where(), "m.mtl:3") << text;
    }
}

TEST(MtlTextureTest, LimitsNumbersOutOfRange) {
    EXPECT_EQ(parse("-s 1.1e9 -1e30 a.png").scale, glm::dvec2(1e9, -1e9));
    EXPECT_EQ(parse("a.png -o 0 1e300").offset, glm::dvec2(0.0, 1e9));
    EXPECT_EQ(parse("-bm 1e300 a.png").bumpMultiplier, 1e6);
    for (const char* text : {"-s 1.1e9 a.png", "a.png -s 1 -1e30", "-o 0 1.1e9 a", "-bm -1e7 a"})
        EXPECT_TRUE(parse(text).isLimited) << text;
    EXPECT_EQ(parse("-s 1e9 -1e9 1e30 a.png").scale, glm::dvec2(1e9, -1e9));
    EXPECT_FALSE(parse("-s 1e9 -1e9 1e30 -bm -1e6 a.png").isLimited);
}

TEST(MtlTextureTest, LongLinesTakeTimeInProportion) {
    std::string options;
    std::string words;
    for (int i = 0; i < 100'000; ++i) {
        options += " -s 1";
        words += " -mm 1 1";
    }
    for (const std::string& text :
         {"a" + options + " b", "a" + options, options + " a", "a" + options + " -s x",
          "a" + std::string(1'000'000, '-'), words + " a" + options + " b"}) {
        EXPECT_LT(processorSeconds([&] { parse(text); }), 1.0) << text.substr(0, 20);
    }
}

} // namespace
} // namespace calotype::test
