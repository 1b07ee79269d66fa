#include "image/layers.h"

#include <cstring>
#include <set>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/exr.h"
#include "support/scratch_folder.h"

namespace calotype {
namespace {

using test::ScratchFolder;
using test::writeBytes;

const std::vector<std::string> kAllLayers = {"albedo",   "normal",    "depth",
                                             "position", "primitive", "uv"};

/// Hits whose numbers are all different, but for one that shows nothing.
FirstHitImage distinctHits(uint32_t width, uint32_t height) {
    FirstHitImage hits(width, height);
    float number = 0.0f;
    const auto next = [&] { return number += 0.37f; };
    for (FirstHit& hit : hits.pixels) {
        hit.albedo = {next(), next(), next()};
        hit.normal = {next(), next(), -next()};
        hit.position = {1e6f * next(), next(), -next()};
        hit.depth = next();
        hit.primitive = 0x9000'0001u + static_cast<uint32_t>(number); // no float, no int
        hit.uv = {next(), next()};
    }
    hits.pixels[width + 1] = {};
    return hits;
}

Picture greyPicture(uint32_t width, uint32_t height) {
    Picture picture{Image(width, height)};
    for (glm::vec3& pixel : picture.color.pixels)
        pixel = glm::vec3(0.5f);
    return picture;
}

/// A grey picture with layers of the hits.
Picture pictureWith(const FirstHitImage& hits, const std::vector<std::string>& layers) {
    Picture picture = greyPicture(hits.width, hits.height);
    for (const std::string& name : layers)
        for (const Channel& channel : channelsOf(*findLayer(name), hits))
            picture.channels.push_back(channel);
    return picture;
}

void expectSame(const FirstHitImage& a, const FirstHitImage& b) {
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    EXPECT_EQ(std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(FirstHit)), 0);
}

TEST(LayersTest, AreThoseOfTheTable) {
    EXPECT_EQ(namesOf(allLayers()),
              "albedo, normal, depth, position, primitive, uv, meanAlbedo, meanNormal, "
              "meanDepth, alpha, error, cryptoObject, cryptoMaterial");
    EXPECT_EQ(namesOf(layersOfFilms()), "error");
    EXPECT_EQ(findLayer("position")->channels,
              (std::vector<std::string>{"position.X", "position.Y", "position.Z"}));
    EXPECT_EQ(findLayer("Position"), nullptr);
    EXPECT_EQ(findLayer("cryptoMaterial")->channels.size(), 12u);
    EXPECT_EQ(findLayer("cryptoMaterial")->channels[0], "CryptoMaterial00.R");
    EXPECT_EQ(findLayer("cryptoMaterial")->channels[11], "CryptoMaterial02.A");
    EXPECT_TRUE(hasSource(allLayers(), LayerSource::FirstHit));
    EXPECT_FALSE(hasSource(layersOfFilms(), LayerSource::FirstHit));
}

TEST(LayersTest, OfErrorsAreTheirNumbers) {
    const std::vector<PixelError> errors = {{1.0f, 2.0f}, {3.0f, 4.0f}};
    const std::vector<Channel> channels = channelsOf(*findLayer("error"), errors);
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].name, "error.SE");
    EXPECT_EQ(std::get<0>(channels[0].pixels), (std::vector<float>{1.0f, 3.0f}));
    EXPECT_EQ(channels[1].name, "error.CI95");
    EXPECT_EQ(std::get<0>(channels[1].pixels), (std::vector<float>{2.0f, 4.0f}));
}

TEST(LayersTest, ComeBackBitForBit) {
    const FirstHitImage hits = distinctHits(21, 34);
    const ScratchFolder folder;
    writeExr(folder / "a.exr", pictureWith(hits, kAllLayers));
    expectSame(readFirstHits(folder / "a.exr"), hits);
    EXPECT_EQ(readExr(folder / "a.exr").pixels, greyPicture(21, 34).color.pixels);
}

// A crop's data window does not begin at the film's origin.
TEST(LayersTest, OfACropComeBackToo) {
    const FirstHitImage hits = distinctHits(5, 4);
    Picture picture = pictureWith(hits, kAllLayers);
    picture.crop = CropPlacement{600, 470, 640, 480};
    const ScratchFolder folder;
    writeExr(folder / "a.exr", picture);
    expectSame(readFirstHits(folder / "a.exr"), hits);
}

/// The values of a float channel, read by its name as any other program would.
std::vector<float> channelOf(const std::filesystem::path& path, const char* name) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    std::vector<float> values(static_cast<size_t>(width) * height);
    Imf::FrameBuffer buffer;
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), window));
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return values;
}

// OpenEXR's own rule for layers, which Blender and Nuke follow: the name before the last dot.
TEST(LayersTest, HaveTheNamesThatOthersRead) {
    const FirstHitImage hits = distinctHits(3, 2);
    const ScratchFolder folder;
    writeExr(folder / "a.exr", pictureWith(hits, kAllLayers));
    {
        const Imf::InputFile file((folder / "a.exr").c_str());
        const Imf::ChannelList& channels = file.header().channels();
        std::set<std::string> layers;
        channels.layers(layers);
        EXPECT_EQ(layers, std::set<std::string>(kAllLayers.begin(), kAllLayers.end()));
        size_t count = 0;
        for (auto channel = channels.begin(); channel != channels.end(); ++channel, ++count)
            EXPECT_EQ(channel.channel().type,
                      std::string(channel.name()) == "primitive.ID" ? Imf::UINT : Imf::FLOAT)
                << channel.name();
        EXPECT_EQ(count, 3u + 13u);
    }
    for (size_t i = 0; i < hits.pixels.size(); ++i) {
        const FirstHit& hit = hits.pixels[i];
        const auto value = [&](const char* name) { return channelOf(folder / "a.exr", name)[i]; };
        EXPECT_EQ(glm::vec3(value("albedo.R"), value("albedo.G"), value("albedo.B")), hit.albedo);
        EXPECT_EQ(glm::vec3(value("normal.X"), value("normal.Y"), value("normal.Z")), hit.normal);
        EXPECT_EQ(glm::vec3(value("position.X"), value("position.Y"), value("position.Z")),
                  hit.position);
        EXPECT_EQ(value("depth.Z"), hit.depth);
        EXPECT_EQ(glm::vec2(value("uv.U"), value("uv.V")), hit.uv);
    }
}

TEST(LayersTest, AreThoseThatAreWanted) {
    const FirstHitImage hits = distinctHits(4, 3);
    const ScratchFolder folder;
    writeExr(folder / "a.exr", pictureWith(hits, {"primitive", "depth"}));
    FirstHitImage expected(4, 3);
    for (size_t i = 0; i < hits.pixels.size(); ++i) {
        expected.pixels[i].primitive = hits.pixels[i].primitive;
        expected.pixels[i].depth = hits.pixels[i].depth;
    }
    expectSame(readFirstHits(folder / "a.exr"), expected);
}

TEST(LayersTest, AreNotReadFromWhatHasNone) {
    const ScratchFolder folder;
    EXPECT_THROW(readFirstHits(folder / "missing.exr"), SceneError);
    writeBytes(folder / "text.exr", "no picture at all");
    EXPECT_THROW(readFirstHits(folder / "text.exr"), SceneError);
    writeExr(folder / "plain.exr", greyPicture(4, 3));
    EXPECT_THROW(readFirstHits(folder / "plain.exr"), SceneError);
}

TEST(LayersDeathTest, OfAnotherSizeAreAMistake) {
    Picture picture = pictureWith(distinctHits(3, 4), kAllLayers);
    picture.color = Image(4, 4);
    EXPECT_DEATH(writeExr("/dev/null", picture), "check failed");
}

} // namespace
} // namespace calotype
