#include "film/film_file.h"

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/content_hash.h"
#include "base/error.h"
#include "film/block_count.h"
#include "film/same_origin.h"
#include "support/program.h"

namespace calotype::test {
namespace {

using Block = std::vector<glm::vec4>;

/// Large enough for several chunks: 90,000 pixels have 270,000 sums of colours.
constexpr uint32_t kWidth = 300;
constexpr uint32_t kHeight = 300;

Block randomBlock(uint32_t index, size_t pixels) {
    std::mt19937 random(index);
    std::uniform_real_distribution<float> mantissa(-1.0f, 1.0f);
    std::uniform_int_distribution<int> exponent(-70, 39);
    Block block(pixels);
    for (glm::vec4& sum : block) {
        for (int channel = 0; channel < 3; ++channel)
            sum[channel] = std::ldexp(mantissa(random), exponent(random));
        sum.w = static_cast<float>(shared::kSamplesPerBlock);
    }
    return block;
}

Film filmOf(uint32_t width, uint32_t height, const std::vector<uint32_t>& blocks) {
    Film film(width, height, 0.25);
    for (const uint32_t block : blocks)
        film.addBlock(block, randomBlock(block, film.pixelCount()), {block, 2, 0, 0});
    return film;
}

FilmLabel someLabel() {
    FilmLabel label;
    label.sceneHash = 0xfedcba9876543210;
    label.settings = {{"seed", "7"}, {"sampler", "sobol"}};
    label.devices = {"one", "two \"quoted\""};
    return label;
}

std::string errorOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

class FilmFileTest : public testing::Test {
protected:
    TestFolder folder_;
    std::string path_ = folder_ / "x.film";
};

TEST_F(FilmFileTest, GivesBackWhatItWasGiven) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {7u, 3u}, {kWidth, kHeight}}) {
        const Film film = filmOf(width, height, {3, 0, 9, 8});
        writeFilm(path_, someLabel(), film);
        const KeptFilm kept = readFilm(path_);
        EXPECT_TRUE(kept.film.sums() == film.sums());
        EXPECT_EQ(kept.film.width(), width);
        EXPECT_EQ(kept.film.height(), height);
        EXPECT_EQ(kept.film.unit(), 0.25);
        EXPECT_EQ(kept.label.sceneHash, someLabel().sceneHash);
        EXPECT_EQ(kept.label.settings, someLabel().settings);
        EXPECT_EQ(kept.label.devices, someLabel().devices);
    }
    EXPECT_TRUE(isFilm(path_));
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"x.film"});
}

// It says nothing about which samples there are, so films with and without it are joined.
TEST_F(FilmFileTest, KeepsTheCamera) {
    FilmLabel label = someLabel();
    const Film film = filmOf(2, 2, {0});
    writeFilm(path_, label, film);
    EXPECT_EQ(readText(path_).find("camera"), std::string::npos) << "as films of version 0.1.0";
    const KeptFilm without = readFilm(path_);
    EXPECT_EQ(without.label.camera, "");
    label.camera = R"({"position":[0,1,2]})";
    EXPECT_EQ(errorOf([&] { requireSameOrigin(path_, without, label, 2, 2, 0.25); }), "");
    writeFilm(path_, label, film);
    EXPECT_EQ(readFilm(path_).label.camera, label.camera);
}

TEST_F(FilmFileTest, KeepsAnEmptyFilm) {
    writeFilm(path_, {}, Film(2, 2, 1.0));
    EXPECT_TRUE(readFilm(path_).film.blocks().empty());
}

/// The version of the format.
int versionOf(const std::string& bytes) { return bytes[8]; }

TEST_F(FilmFileTest, KeepsTheColorsOfReplicas) {
    Film film(30, 20, 0.25, ReplicaDetail::Color);
    for (const uint32_t block : {2u, 7u})
        film.addBlock(block, randomBlock(block, film.pixelCount()));
    writeFilm(path_, someLabel(), film);
    EXPECT_EQ(versionOf(readText(path_)), 2);
    const KeptFilm kept = readFilm(path_);
    EXPECT_EQ(kept.film.detail(), ReplicaDetail::Color);
    EXPECT_TRUE(kept.film.sums() == film.sums());
    const auto difference = [&](ReplicaDetail detail) {
        return errorOf([&] { requireSameOrigin(path_, kept, someLabel(), 30, 20, 0.25, detail); });
    };
    EXPECT_EQ(difference(ReplicaDetail::Color), "");
    EXPECT_NE(difference(ReplicaDetail::Luminance).find("a render for denoising"),
              std::string::npos);
}

FilmLabel transparentLabel() {
    FilmLabel label = someLabel();
    label.settings["transparent"] = "on";
    return label;
}

/// With hidden samples in most pixels.
Film transparentFilm(uint32_t width, uint32_t height, ReplicaDetail detail) {
    Film film(width, height, 0.25, detail, true);
    for (const uint32_t block : {2u, 7u}) {
        Block sums = randomBlock(block, film.pixelCount());
        for (size_t i = 0; i < sums.size(); ++i)
            sums[i].w = blockCount({16, static_cast<uint32_t>((i + block) % 17)});
        film.addBlock(block, sums);
    }
    return film;
}

TEST_F(FilmFileTest, KeepsAlpha) {
    for (const ReplicaDetail detail : {ReplicaDetail::Luminance, ReplicaDetail::Color}) {
        const Film film = transparentFilm(kWidth, kHeight, detail);
        writeFilm(path_, transparentLabel(), film);
        EXPECT_EQ(versionOf(readText(path_)), 3);
        const KeptFilm kept = readFilm(path_);
        EXPECT_EQ(kept.film.detail() == detail, true);
        EXPECT_TRUE(kept.film.sums() == film.sums());
        EXPECT_EQ(kept.film.alpha(), film.alpha());
    }
}

DenoiserFeatures someFeatures(uint32_t width, uint32_t height) {
    DenoiserFeatures features{Image(width, height), Image(width, height)};
    for (size_t i = 0; i < features.albedo.pixels.size(); ++i) {
        const auto x = static_cast<float>(i);
        features.albedo.pixels[i] = {0.5f + 0.5f * std::sin(x), 0.0f, 1.0f / (1.0f + x)};
        features.normal.pixels[i] = {std::sin(x), -std::cos(x), 1e-9f * x};
    }
    return features;
}

// 120,000 pixels have 360,000 numbers of an albedo, more than a chunk.
TEST_F(FilmFileTest, KeepsTheFeaturesOfDenoisers) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {400u, 300u}}) {
        const DenoiserFeatures features = someFeatures(width, height);
        const Film film(width, height, 0.25, ReplicaDetail::Color);
        writeFilm(path_, someLabel(), film, features);
        const KeptFilm kept = readFilm(path_);
        ASSERT_TRUE(kept.features);
        EXPECT_EQ(kept.features->albedo.pixels, features.albedo.pixels);
        EXPECT_EQ(kept.features->normal.pixels, features.normal.pixels);
        EXPECT_TRUE(kept.features->areMeans);
        EXPECT_TRUE(kept.film.sums() == film.sums());
        writeFilm(path_, someLabel(), film);
        EXPECT_FALSE(readFilm(path_).features);
    }
}

TEST(DenoiserFeaturesTest, HaveAnOrder) {
    const DenoiserFeatures features = someFeatures(4, 3);
    EXPECT_FALSE(isBefore(features, features));
    for (const bool isOfAlbedo : {true, false}) {
        DenoiserFeatures other = features;
        (isOfAlbedo ? other.albedo : other.normal).pixels[7].y += 0.25f;
        EXPECT_NE(isBefore(features, other), isBefore(other, features));
    }
}

// So that older programs read it.
TEST_F(FilmFileTest, OfLuminancesIsOfVersionOne) {
    writeFilm(path_, someLabel(), filmOf(3, 2, {0}));
    EXPECT_EQ(versionOf(readText(path_)), 1);
}

TEST_F(FilmFileTest, IsTheSameBytesInAnyOrderOfBlocks) {
    writeFilm(path_, someLabel(), filmOf(20, 10, {0, 1, 2, 5}));
    const std::string bytes = readText(path_);
    writeFilm(path_, someLabel(), filmOf(20, 10, {5, 2, 0, 1}));
    EXPECT_EQ(readText(path_), bytes);
    Film joined = filmOf(20, 10, {5, 1});
    joined.add(filmOf(20, 10, {0, 2}));
    writeFilm(path_, someLabel(), joined);
    EXPECT_EQ(readText(path_), bytes);
}

// Every byte is under the checksum, or is the checksum, the length, the version or the signature.
TEST_F(FilmFileTest, RefusesAFlippedByteAnywhere) {
    writeFilm(path_, someLabel(), filmOf(3, 2, {0, 4}));
    const std::string bytes = readText(path_);
    for (size_t i = 0; i < bytes.size(); ++i) {
        std::string damaged = bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
        const std::string path = folder_.write("damaged.film", damaged);
        EXPECT_NE(errorOf([&] { readFilm(path); }), "") << "byte " << i;
    }
}

TEST_F(FilmFileTest, RefusesABeginning) {
    writeFilm(path_, someLabel(), filmOf(3, 2, {0, 4}));
    const std::string bytes = readText(path_);
    for (size_t size = 0; size < bytes.size(); size += size < 64 ? 1 : 37) {
        const std::string path = folder_.write("damaged.film", bytes.substr(0, size));
        EXPECT_NE(errorOf([&] { readFilm(path); }), "") << size;
    }
    const std::string longer = folder_.write("damaged.film", bytes + "x");
    EXPECT_NE(errorOf([&] { readFilm(longer); }).find("checksum"), std::string::npos);
}

TEST_F(FilmFileTest, SaysWhatIsWrong) {
    EXPECT_NE(errorOf([&] { readFilm(folder_ / "none.film"); }).find("No such file"),
              std::string::npos);
    const std::string text = folder_.write("a.film", "{ \"shapes\": [] }, which is no film");
    EXPECT_NE(errorOf([&] { readFilm(text); }).find("no film"), std::string::npos);
    EXPECT_FALSE(isFilm(text));
    writeFilm(path_, {}, Film(1, 1, 1.0));
    std::string bytes = readText(path_);
    bytes[8] = 9;
    const std::string newer = folder_.write("b.film", bytes);
    EXPECT_NE(errorOf([&] { readFilm(newer); }).find("format 9"), std::string::npos);
}

/// A film's bytes with a part of the description changed, under a checksum that is right.
std::string withDescription(std::string bytes, const std::string& from, const std::string& to) {
    const size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    bytes.replace(at, from.size(), to);
    const auto put = [&](size_t place, uint64_t number, size_t count) {
        for (size_t i = 0; i < count; ++i)
            bytes[place + i] = static_cast<char>(number >> 8 * i);
    };
    const auto length =
        static_cast<unsigned char>(bytes[12]) | static_cast<unsigned char>(bytes[13]) << 8;
    put(12, length + to.size() - from.size(), 4);
    ContentHash hash;
    hash.add(std::string_view(bytes).substr(24));
    put(16, hash.value(), 8);
    return bytes;
}

TEST_F(FilmFileTest, RefusesDescriptionsThatMakeNoSense) {
    writeFilm(path_, someLabel(), filmOf(3, 2, {0, 4}));
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"\"width\":3", "\"width\":9"},
          {"\"width\":3", "\"width\":0"},
          {"[[0,1],[4,5]]", "[[4,5],[0,1]]"},
          {"[[0,1],[4,5]]", "[[0,1],[5,5]]"},
          {"\"unit_exponent\":-2", "\"unit_exponent\":-999"},
          {"\"scene_hash\":\"f", "\"scene_hash\":\"x"},
          {"\"devices\":[", "\"devices\":7,\"d\":["}}) {
        const std::string path =
            folder_.write("odd.film", withDescription(readText(path_), from, to));
        EXPECT_NE(errorOf([&] { readFilm(path); }).find("makes no sense"), std::string::npos) << to;
    }
}

TEST_F(FilmFileTest, RefusesFeaturesOfAnotherSize) {
    writeFilm(path_, someLabel(), Film(30, 20, 0.25, ReplicaDetail::Color), someFeatures(30, 20));
    const std::string bytes = readText(path_);
    const size_t at = bytes.find("\"feature_bytes\":[");
    ASSERT_NE(at, std::string::npos);
    const std::string list = bytes.substr(at, bytes.find(']', at) + 1 - at);
    const std::string first = list.substr(0, list.find(',')) + "]";
    for (const std::string& to :
         {first, std::string("\"feature_bytes\":[0,0]"), list.substr(0, list.size() - 1) + ",0]"}) {
        const std::string path = folder_.write("odd.film", withDescription(bytes, list, to));
        EXPECT_NE(errorOf([&] { readFilm(path); }).find("makes no sense"), std::string::npos) << to;
    }
}

/// Of one pixel and one block, with a number of hidden samples.
Film filmOfHidden(FixedPoint hidden) {
    Film film(1, 1, 0.25, ReplicaDetail::Luminance, true);
    film.addBlock(0, randomBlock(0, 1));
    Film::Sums sums = film.sums();
    sums.hiddenSamples.write(0, std::vector{hidden});
    return {1, 1, 0.25, std::move(sums)};
}

// The share of a pixel that shows a surface is made from it, in unsigned numbers.
TEST_F(FilmFileTest, RefusesNumbersOfHiddenSamplesThatNoFilmHas) {
    for (const FixedPoint hidden : {0, 16}) {
        writeFilm(path_, transparentLabel(), filmOfHidden(hidden));
        EXPECT_EQ(readFilm(path_).film.alpha(), std::vector{hidden == 0 ? 1.0f : 0.0f});
    }
    for (const FixedPoint hidden : {FixedPoint{-1}, FixedPoint{17}, FixedPoint{1} << 64}) {
        writeFilm(path_, transparentLabel(), filmOfHidden(hidden));
        EXPECT_NE(errorOf([&] { readFilm(path_); }).find("makes no sense"), std::string::npos);
    }
}

// A film of fewer blocks, so that the numbers are too large for it.
TEST_F(FilmFileTest, RefusesMoreHiddenSamplesThanItsBlocksHave) {
    writeFilm(path_, transparentLabel(), transparentFilm(20, 10, ReplicaDetail::Luminance));
    const std::string path =
        folder_.write("odd.film", withDescription(readText(path_), "[[2,3],[7,8]]", "[[2,3]]"));
    EXPECT_NE(errorOf([&] { readFilm(path); }).find("makes no sense: sums"), std::string::npos);
}

// Else films with and without alpha would be joined.
TEST_F(FilmFileTest, RefusesALabelThatContradictsTheVersion) {
    const Film transparent = transparentFilm(3, 2, ReplicaDetail::Luminance);
    writeFilm(path_, transparentLabel(), transparent);
    const std::string on = "\"transparent\":\"on\"";
    const std::string off = "\"transparent\":\"off\"";
    const std::string opaque = folder_.write("a.film", withDescription(readText(path_), on, off));
    FilmLabel label = someLabel();
    label.settings["transparent"] = "off";
    writeFilm(path_, label, filmOf(3, 2, {0}));
    const std::string hidden = folder_.write("b.film", withDescription(readText(path_), off, on));
    for (const std::string& path : {opaque, hidden})
        EXPECT_NE(errorOf([&] { readFilm(path); }).find("makes no sense: transparent"),
                  std::string::npos);
    EXPECT_DEATH(writeFilm(path_, someLabel(), transparent), "check failed");
    EXPECT_DEATH(writeFilm(path_, transparentLabel(), filmOf(3, 2, {0})), "check failed");
}

// The version says which sums there are.
TEST_F(FilmFileTest, RefusesTheSumsOfAnotherVersion) {
    for (const auto detail : {ReplicaDetail::Luminance, ReplicaDetail::Color}) {
        writeFilm(path_, someLabel(), Film(3, 2, 0.25, detail));
        std::string bytes = readText(path_);
        bytes[8] = detail == ReplicaDetail::Color ? 1 : 2;
        const std::string path = folder_.write("odd.film", bytes);
        EXPECT_NE(errorOf([&] { readFilm(path); }).find("makes no sense"), std::string::npos);
    }
}

TEST_F(FilmFileTest, RefusesFilmsOfOtherOrigin) {
    writeFilm(path_, someLabel(), filmOf(3, 2, {0}));
    const KeptFilm kept = readFilm(path_);
    const auto difference = [&](const FilmLabel& label, double unit = 0.25) {
        return errorOf([&] { requireSameOrigin(path_, kept, label, 3, 2, unit); });
    };
    FilmLabel other = someLabel();
    other.devices = {"three"};
    EXPECT_EQ(difference(other), "") << "films of several devices go together";
    other.settings["seed"] = "8";
    EXPECT_NE(difference(other).find("its setting seed is 7, not 8"), std::string::npos);
    other.settings.erase("seed");
    EXPECT_NE(difference(other).find("its setting seed is 7, not none"), std::string::npos);
    other = someLabel();
    other.settings["transparent"] = "on";
    EXPECT_NE(difference(other).find("its setting transparent is none, not on; leave out "
                                     "--transparent to go on with it"),
              std::string::npos);
    other = someLabel();
    other.settings["lens"] = "wide";
    EXPECT_NE(difference(other).find("its setting lens is none, not wide"), std::string::npos);
    other = someLabel();
    other.sceneHash++;
    EXPECT_NE(difference(other).find("another scene"), std::string::npos);
    EXPECT_NE(errorOf([&] {
                  requireSameOrigin(path_, kept, someLabel(), 2, 3, 0.25);
              }).find("another size"),
              std::string::npos);
    EXPECT_NE(difference(someLabel(), 0.5).find("lights of another strength"), std::string::npos);
}

} // namespace
} // namespace calotype::test
