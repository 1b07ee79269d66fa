#include "image/exr.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "support/scratch_folder.h"

namespace calotype {
namespace {

using test::readBytes;
using test::ScratchFolder;
using test::writeBytes;

Image gradient(uint32_t width, uint32_t height) {
    Image image(width, height);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            image.at(x, y) = glm::vec3(x, y, x * y) / 7.0f;
    return image;
}

TEST(ExrTest, ComesBackBitForBit) {
    const float infinity = std::numeric_limits<float>::infinity();
    Image image = gradient(50, 41);
    image.at(0, 0) = {-1.5f, 1e-30f, 1e30f};
    image.at(49, 40) = {std::nanf("7"), infinity, -infinity};
    image.at(3, 17) = {-0.0f, 1e-42f, 0.1f};
    const ScratchFolder folder;
    writeExr(folder / "a.exr", {image});
    const Image read = readExr(folder / "a.exr");
    ASSERT_EQ(read.width, 50u);
    ASSERT_EQ(read.height, 41u);
    EXPECT_EQ(std::memcmp(read.pixels.data(), image.pixels.data(),
                          image.pixels.size() * sizeof(glm::vec3)),
              0);
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(ExrTest, HeaderSaysHowThePictureCameAbout) {
    Picture picture{gradient(4, 3)};
    picture.metadata = {{"version", "1.2.3"}, {"sceneHash", "0123456789abcdef"},
                        {"seed", 4e9},        {"sampler", "sobol"},
                        {"spp", 64},          {"seconds", 1.25}};
    const ScratchFolder folder;
    writeExr(folder / "a.exr", picture);

    const Imf::InputFile file((folder / "a.exr").c_str());
    const Imf::Header& header = file.header();
    using Text = Imf::StringAttribute;
    EXPECT_EQ(header.typedAttribute<Text>("calotype:version").value(), "1.2.3");
    EXPECT_EQ(header.typedAttribute<Text>("calotype:sceneHash").value(), "0123456789abcdef");
    EXPECT_EQ(header.typedAttribute<Imf::DoubleAttribute>("calotype:seed").value(), 4e9);
    EXPECT_EQ(header.typedAttribute<Text>("calotype:sampler").value(), "sobol");
    EXPECT_EQ(header.typedAttribute<Imf::IntAttribute>("calotype:spp").value(), 64);
    EXPECT_EQ(header.typedAttribute<Imf::DoubleAttribute>("calotype:seconds").value(), 1.25);
    EXPECT_EQ(header.compression(), Imf::ZIP_COMPRESSION);
    EXPECT_EQ(header.displayWindow(), Imath::Box2i({0, 0}, {3, 2}));
    EXPECT_EQ(header.dataWindow(), Imath::Box2i({0, 0}, {3, 2}));
    for (const char* name : {"R", "G", "B"})
        EXPECT_EQ(header.channels()[name].type, Imf::FLOAT) << name;
}

TEST(ExrTest, MetadataAndCropComeBack) {
    Picture picture{gradient(4, 3)};
    picture.metadata = {{"denoisedError", 0.125}, {"spp", 64}, {"version", "1.2.3"}};
    picture.crop = CropPlacement{5, 7, 640, 480};
    const ScratchFolder folder;
    writeExr(folder / "a.exr", picture);
    const Picture read = readExrPicture(folder / "a.exr");
    ASSERT_EQ(read.metadata.size(), 3u);
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(read.metadata[i].name, picture.metadata[i].name);
        EXPECT_EQ(read.metadata[i].value, picture.metadata[i].value);
    }
    ASSERT_TRUE(read.crop);
    EXPECT_EQ(read.crop->x, 5u);
    EXPECT_EQ(read.crop->y, 7u);
    EXPECT_EQ(read.crop->filmWidth, 640u);
    EXPECT_EQ(read.crop->filmHeight, 480u);
    picture.crop.reset();
    writeExr(folder / "a.exr", picture);
    EXPECT_FALSE(readExrPicture(folder / "a.exr").crop);
}

TEST(ExrTest, CropLiesWhereItBelongs) {
    Picture picture{gradient(4, 3)};
    picture.crop = CropPlacement{5, 7, 640, 480};
    const ScratchFolder folder;
    writeExr(folder / "a.exr", picture);
    {
        const Imf::InputFile file((folder / "a.exr").c_str());
        EXPECT_EQ(file.header().displayWindow(), Imath::Box2i({0, 0}, {639, 479}));
        EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({5, 7}, {8, 9}));
    }
    const Image read = readExr(folder / "a.exr");
    ASSERT_EQ(read.width, 4u);
    ASSERT_EQ(read.height, 3u);
    EXPECT_EQ(read.pixels, picture.color.pixels);
}

TEST(ExrDeathTest, CropOutsideItsFilmIsAMistake) {
    Picture picture{gradient(4, 3)};
    picture.crop = CropPlacement{637, 0, 640, 480};
    EXPECT_DEATH(writeExr("/dev/null", picture), "check failed");
}

/// A file as another program may write it: half floats, an extra channel, a window off the origin.
void writeForeignExr(const std::filesystem::path& path, std::vector<const char*> names) {
    const Imath::Box2i window({-2, 3}, {-1, 3});
    Imf::Header header(Imath::Box2i({0, 0}, {9, 9}), window);
    Imf::FrameBuffer buffer;
    std::vector<std::array<half, 2>> rows;
    for (size_t i = 0; i < names.size(); ++i)
        rows.push_back({half(static_cast<float>(i)), half(static_cast<float>(i) + 0.5f)});
    for (size_t i = 0; i < names.size(); ++i) {
        header.channels().insert(names[i], Imf::Channel(Imf::HALF));
        buffer.insert(names[i], Imf::Slice::Make(Imf::HALF, rows[i].data(), window));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(1);
}

TEST(ExrTest, ReadsHalvesByTheNamesOfTheirChannels) {
    const ScratchFolder folder;
    writeForeignExr(folder / "a.exr", {"R", "A", "B", "G"});
    const Image image = readExr(folder / "a.exr");
    ASSERT_EQ(image.width, 2u);
    ASSERT_EQ(image.height, 1u);
    EXPECT_EQ(image.at(0, 0), glm::vec3(0.0f, 3.0f, 2.0f));
    EXPECT_EQ(image.at(1, 0), glm::vec3(0.5f, 3.5f, 2.5f));
}

TEST(ExrTest, RefusesWhatItCannotRead) {
    const ScratchFolder folder;
    EXPECT_THROW(readExr(folder / "missing.exr"), SceneError);
    writeBytes(folder / "text.exr", "no picture at all");
    EXPECT_THROW(readExr(folder / "text.exr"), SceneError);
    writeForeignExr(folder / "grey.exr", {"Y"});
    EXPECT_THROW(readExr(folder / "grey.exr"), SceneError);

    writeExr(folder / "whole.exr", {gradient(50, 41)});
    const std::string bytes = readBytes(folder / "whole.exr");
    writeBytes(folder / "half.exr", bytes.substr(0, bytes.size() / 2));
    EXPECT_THROW(readExr(folder / "half.exr"), SceneError);
}

} // namespace
} // namespace calotype
