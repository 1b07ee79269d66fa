// EXR files that claim more than they hold: refused before memory is spent on the claim.

#include <cstring>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/exr.h"
#include "support/scratch_folder.h"
#include "unit/memory_use.h"

namespace calotype::test {
namespace {

constexpr uint32_t kWidth = 30;
constexpr uint32_t kHeight = 40;

std::string exrBytes() {
    const ScratchFolder folder;
    Picture picture{Image(kWidth, kHeight)};
    picture.metadata = {{"version", ""}};
    writeExr(folder / "a.exr", picture);
    return readBytes(folder / "a.exr");
}

/// Where the value of an attribute starts, after its name, type and size.
size_t valueOf(const std::string& bytes, const std::string& name, const std::string& type) {
    const std::string start = name + '\0' + type + '\0';
    const size_t at = bytes.find(start);
    EXPECT_NE(at, std::string::npos) << name;
    return at + start.size() + sizeof(uint32_t);
}

void setInt(std::string& bytes, size_t at, uint32_t value) {
    std::memcpy(&bytes.at(at), &value, sizeof value);
}

/// Sets the data window's last column and row.
std::string withWindowTo(std::string bytes, uint32_t x, uint32_t y) {
    const size_t window = valueOf(bytes, "dataWindow", "box2i");
    setInt(bytes, window + 8, x);
    setInt(bytes, window + 12, y);
    return bytes;
}

void expectRefused(const std::string& bytes, const std::string& fragment) {
    const ScratchFolder folder;
    writeBytes(folder / "a.exr", bytes);
    std::string message;
    const MemoryGauge memory;
    try {
        readExr(folder / "a.exr");
    } catch (const SceneError& error) {
        message = error.what();
    }
    EXPECT_NE(message.find(fragment), std::string::npos) << "says: " << message;
    // One step of 50 MB ahead of what is there.
    EXPECT_LT(memory.peak(), (int64_t{128} << 20) + kSanitizerMemory);
}

TEST(ExrCheckTest, RefusesAttributesLongerThanTheFile) {
    std::string bytes = exrBytes();
    setInt(bytes, valueOf(bytes, "calotype:version", "string") - 4, 0x40000000);
    expectRefused(bytes, "ttribute");
}

TEST(ExrCheckTest, RefusesSidesLargerThanAnyFilm) {
    expectRefused(withWindowTo(exrBytes(), 65535, kHeight - 1), "largest side of 65535");
    expectRefused(withWindowTo(exrBytes(), kWidth - 1, 65535), "largest side of 65535");
}

TEST(ExrCheckTest, RefusesMoreChunksThanTheFileHasRoomFor) {
    expectRefused(withWindowTo(exrBytes(), kWidth - 1, 60000), "its end is missing");
}

TEST(ExrCheckTest, RefusesChunksOfExcessiveSize) {
    // 256 rows of 65535 pixels of 5 floats are 336 MB.
    Imf::Header header(static_cast<int>(kWidth), static_cast<int>(kHeight));
    header.compression() = Imf::DWAB_COMPRESSION;
    for (const char* name : {"A", "B", "G", "R", "Z"})
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    const ScratchFolder folder;
    Imf::OutputFile((folder / "a.exr").c_str(), header); // without pixels
    expectRefused(withWindowTo(readBytes(folder / "a.exr"), 65534, kHeight - 1), "256 MiB");
}

TEST(ExrCheckTest, RefusesDeepPixels) {
    Imf::Header header(static_cast<int>(kWidth), static_cast<int>(kHeight));
    header.compression() = Imf::ZIPS_COMPRESSION;
    header.setType(Imf::DEEPSCANLINE);
    header.channels().insert("R", Imf::Channel(Imf::FLOAT));
    const ScratchFolder folder;
    Imf::DeepScanLineOutputFile((folder / "a.exr").c_str(), header);
    expectRefused(readBytes(folder / "a.exr"), "deep");
}

TEST(ExrCheckTest, SpendsNoMemoryOnPixelsThatAreNotThere) {
    // Room for a table of a hundred blocks of 16 rows, which would be 1.3 GB of pixels.
    constexpr uint32_t kBlocks = 100;
    const std::string bytes = exrBytes() + std::string(8 * kBlocks, '\0');
    expectRefused(withWindowTo(bytes, 65534, 16 * kBlocks - 1), "cannot be read");
}

} // namespace
} // namespace calotype::test
