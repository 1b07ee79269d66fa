#include "image/exr.h"

#include <algorithm>
#include <exception>
#include <limits>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/error.h"
#include "base/hexadecimal.h"
#include "image/exr_check.h"
#include "image/exr_error.h"

namespace calotype {
namespace {

constexpr const char* kChannelNames[] = {"R", "G", "B"};

/// A file in memory: OpenEXR goes back to fill in its table of offsets.
class MemoryStream : public Imf::OStream {
public:
    MemoryStream() : Imf::OStream("memory") {}

    void write(const char data[], int size) override {
        const size_t end = position_ + static_cast<size_t>(size);
        if (end > bytes_.size())
            bytes_.resize(end);
        std::copy_n(data, size, bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
        position_ = end;
    }
    uint64_t tellp() override { return position_; }
    void seekp(uint64_t position) override { position_ = position; }

    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    size_t position_ = 0;
};

Imath::Box2i windowAt(uint32_t x, uint32_t y, uint32_t width, uint32_t height) {
    const auto last = [](uint32_t start, uint32_t size) {
        return static_cast<int>(int64_t{start} + size - 1);
    };
    return {Imath::V2i(static_cast<int>(x), static_cast<int>(y)),
            Imath::V2i(last(x, width), last(y, height))};
}

Imf::Header describe(const Image& image, const ExrMetadata& metadata) {
    const CropPlacement crop =
        metadata.crop.value_or(CropPlacement{0, 0, image.width, image.height});
    CALOTYPE_CHECK_LE(uint64_t{crop.x} + image.width, crop.filmWidth);
    CALOTYPE_CHECK_LE(uint64_t{crop.y} + image.height, crop.filmHeight);

    Imf::Header header(windowAt(0, 0, crop.filmWidth, crop.filmHeight),
                       windowAt(crop.x, crop.y, image.width, image.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities()); // the default is Rec. 709
    constexpr auto kMaxInt = static_cast<uint32_t>(std::numeric_limits<int>::max());
    const auto spp = static_cast<int>(std::min(metadata.samplesPerPixel, kMaxInt));
    header.insert("calotype:version", Imf::StringAttribute(metadata.version));
    header.insert("calotype:sceneHash", Imf::StringAttribute(hexadecimal(metadata.sceneHash)));
    header.insert("calotype:seed", Imf::DoubleAttribute(metadata.seed));
    header.insert("calotype:sampler", Imf::StringAttribute(metadata.sampler));
    header.insert("calotype:spp", Imf::IntAttribute(spp));
    header.insert("calotype:seconds", Imf::DoubleAttribute(metadata.seconds));
    for (const char* name : kChannelNames)
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    return header;
}

/// The memory of `image`, seen as three channels of the data window.
Imf::FrameBuffer frameBuffer(Image& image, const Imath::Box2i& dataWindow) {
    Imf::FrameBuffer buffer;
    for (int channel = 0; channel < 3; ++channel)
        buffer.insert(kChannelNames[channel],
                      Imf::Slice::Make(Imf::FLOAT, &image.pixels[0][channel], dataWindow,
                                       sizeof(glm::vec3), sizeof(glm::vec3) * image.width));
    return buffer;
}

void requireColourChannels(const Imf::Header& header, const std::string& where) {
    for (const char* name : kChannelNames) {
        const Imf::Channel* channel = header.channels().findChannel(name);
        if (channel == nullptr || channel->xSampling != 1 || channel->ySampling != 1)
            throw SceneError(where, std::string("the file has no full-size channel ") + name +
                                        "; only RGB pictures can be read");
    }
}

} // namespace

void writeExr(const std::filesystem::path& path, const Image& image, const ExrMetadata& metadata,
              const ExrLayers& layers) {
    CALOTYPE_CHECK_LT(0u, image.pixels.size());
    Imf::Header header = describe(image, metadata);
    // OpenEXR takes pointers to mutable memory even where it only reads.
    Imf::FrameBuffer buffer = frameBuffer(const_cast<Image&>(image), header.dataWindow());
    if (layers.hits) {
        CALOTYPE_CHECK_EQ(layers.hits->width, image.width);
        CALOTYPE_CHECK_EQ(layers.hits->height, image.height);
    }
    CALOTYPE_CHECK_EQ(layers.hits != nullptr, !layers.wanted.empty());
    if (!layers.errors.empty())
        CALOTYPE_CHECK_EQ(layers.errors.size(), image.pixels.size());
    insertLayers(header, layers);
    insertLayers(buffer, header, layers);
    MemoryStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(buffer);
        file.writePixels(static_cast<int>(image.height));
    }
    writeFileAtomically(path, stream.bytes());
}

Image readExr(const std::filesystem::path& path) {
    return withExrErrors(path, [&] {
        const ImageSize size = checkExr(path);
        Imf::InputFile file(path.c_str());
        requireColourChannels(file.header(), path.string());
        const Imath::Box2i window = file.header().dataWindow();
        Image image;
        image.width = size.width;
        image.height = size.height;
        // Memory follows what was decoded, for a small file can claim any size.
        constexpr int kRows = 64; // 50 MB at most; whole tiles and blocks of most files
        for (int y = window.min.y; y <= window.max.y; y += kRows) {
            const int last = std::min(window.max.y, y + kRows - 1);
            const auto rows = static_cast<size_t>(int64_t{last} - window.min.y + 1);
            image.pixels.resize(image.width * rows);
            file.setFrameBuffer(frameBuffer(image, window));
            file.readPixels(y, last);
        }
        return image;
    });
}

} // namespace calotype
