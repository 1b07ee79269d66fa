#include "image/exr.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

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
#include "image/check_size.h"
#include "image/exr_check.h"

namespace calotype {
namespace {

constexpr const char* kColorNames[] = {"R", "G", "B"};

/// A file in memory: OpenEXR seeks back to write its table of offsets.
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

Imf::PixelType typeOf(const Channel& channel) {
    return std::holds_alternative<std::vector<uint32_t>>(channel.pixels) ? Imf::UINT : Imf::FLOAT;
}

/// Of an attribute.
std::string nameInFile(const std::string& name) {
    return name.starts_with(kCryptomattePrefix) ? name : std::string(kMetadataPrefix) + name;
}

/// The inverse; none for an attribute that insertMetadata does not write.
std::optional<std::string> nameFromFile(std::string_view name) {
    if (name.starts_with(kCryptomattePrefix))
        return std::string(name);
    if (name.starts_with(kMetadataPrefix))
        return std::string(name.substr(kMetadataPrefix.size()));
    return std::nullopt;
}

void insertMetadata(Imf::Header& header, const std::vector<Attribute>& metadata) {
    for (const Attribute& attribute : metadata) {
        const std::string name = nameInFile(attribute.name);
        if (const auto* text = std::get_if<std::string>(&attribute.value))
            header.insert(name, Imf::StringAttribute(*text));
        else if (const auto* integer = std::get_if<int32_t>(&attribute.value))
            header.insert(name, Imf::IntAttribute(*integer));
        else
            header.insert(name, Imf::DoubleAttribute(std::get<double>(attribute.value)));
    }
}

/// The attributes that insertMetadata writes.
std::vector<Attribute> metadataOf(const Imf::Header& header) {
    std::vector<Attribute> metadata;
    for (auto i = header.begin(); i != header.end(); ++i) {
        const std::optional<std::string> name = nameFromFile(i.name());
        if (!name)
            continue;
        const auto add = [&](const auto* attribute) {
            if (attribute)
                metadata.push_back({*name, attribute->value()});
        };
        add(dynamic_cast<const Imf::StringAttribute*>(&i.attribute()));
        add(dynamic_cast<const Imf::IntAttribute*>(&i.attribute()));
        add(dynamic_cast<const Imf::DoubleAttribute*>(&i.attribute()));
    }
    return metadata;
}

std::optional<CropPlacement> cropOf(const Imf::Header& header) {
    const Imath::Box2i& all = header.displayWindow();
    const Imath::Box2i& part = header.dataWindow();
    const bool isInside = all.min.x <= part.min.x && all.min.y <= part.min.y &&
                          part.max.x <= all.max.x && part.max.y <= all.max.y;
    const auto size = [](int first, int last) { return int64_t{last} - first + 1; };
    const int64_t width = size(all.min.x, all.max.x);
    const int64_t height = size(all.min.y, all.max.y);
    if (!isInside || all == part || std::max(width, height) > kLargestPictureSide)
        return std::nullopt;
    return CropPlacement{static_cast<uint32_t>(part.min.x - all.min.x),
                         static_cast<uint32_t>(part.min.y - all.min.y),
                         static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

Imf::Header describe(const Picture& picture) {
    const Image& image = picture.color;
    const CropPlacement crop =
        picture.crop.value_or(CropPlacement{0, 0, image.width, image.height});
    CALOTYPE_CHECK_LE(uint64_t{crop.x} + image.width, crop.filmWidth);
    CALOTYPE_CHECK_LE(uint64_t{crop.y} + image.height, crop.filmHeight);

    Imf::Header header(windowAt(0, 0, crop.filmWidth, crop.filmHeight),
                       windowAt(crop.x, crop.y, image.width, image.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities()); // the default is Rec. 709
    insertMetadata(header, picture.metadata);
    for (const char* name : kColorNames)
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    for (const Channel& channel : picture.channels)
        header.channels().insert(channel.name, Imf::Channel(typeOf(channel)));
    return header;
}

/// Describes the picture's memory to OpenEXR; the picture has the rows of the data window.
Imf::FrameBuffer frameBuffer(Picture& picture, const Imath::Box2i& dataWindow) {
    Image& image = picture.color;
    Imf::FrameBuffer buffer;
    const auto insert = [&](const std::string& name, Imf::PixelType type, void* first,
                            size_t stride) {
        buffer.insert(name,
                      Imf::Slice::Make(type, first, dataWindow, stride, stride * image.width));
    };
    for (int i = 0; i < 3; ++i)
        insert(kColorNames[i], Imf::FLOAT, &image.pixels[0][i], sizeof(glm::vec3));
    for (Channel& channel : picture.channels)
        std::visit(
            [&](auto& values) {
                insert(channel.name, typeOf(channel), values.data(), sizeof values[0]);
            },
            channel.pixels);
    return buffer;
}

/// Returns the result of `read`; converts exceptions of OpenEXR to a SceneError at `path`.
template <typename Read>
auto withExrErrors(const std::filesystem::path& path, Read&& read) {
    try {
        return read();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw SceneError(path.string(),
                         std::string("the EXR file cannot be read: ") + error.what());
    }
}

void requireColourChannels(const Imf::Header& header, const std::string& where) {
    for (const char* name : kColorNames) {
        const Imf::Channel* channel = header.channels().findChannel(name);
        if (channel == nullptr || channel->xSampling != 1 || channel->ySampling != 1)
            throw SceneError(where, std::string("the file has no full-size channel ") + name +
                                        "; only RGB pictures can be read");
    }
}

bool isColor(std::string_view channel) {
    return std::ranges::any_of(kColorNames, [&](const char* name) { return channel == name; });
}

/// The channels of a file other than its colour, still empty.
std::vector<Channel> otherChannels(const Imf::Header& header) {
    std::vector<Channel> channels;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        if (isColor(i.name()) || i.channel().xSampling != 1 || i.channel().ySampling != 1)
            continue;
        Channel& channel = channels.emplace_back(Channel{i.name(), {}});
        if (i.channel().type == Imf::UINT)
            channel.pixels = std::vector<uint32_t>();
    }
    return channels;
}

void resize(Picture& picture, size_t pixels) {
    picture.color.pixels.resize(pixels);
    for (Channel& channel : picture.channels)
        std::visit([&](auto& values) { values.resize(pixels); }, channel.pixels);
}

Picture readPicture(const std::filesystem::path& path, bool wantsAll) {
    const ImageSize size = checkExr(path);
    Imf::InputFile file(path.c_str());
    requireColourChannels(file.header(), path.string());
    const Imath::Box2i window = file.header().dataWindow();
    Picture picture;
    picture.color.width = size.width;
    picture.color.height = size.height;
    if (wantsAll) {
        picture.channels = otherChannels(file.header());
        picture.metadata = metadataOf(file.header());
        picture.crop = cropOf(file.header());
    }
    // Memory grows with the decoded rows, because a small file can claim any size: 64 rows at a
    // time, whole tiles and blocks of most files, or fewer, of 64 MB.
    constexpr size_t kMostRows = 64;
    constexpr size_t kMostBytes = size_t{64} << 20;
    const size_t bytesOfRow = size.width * sizeof(float) * (3 + picture.channels.size());
    const auto rowCount =
        static_cast<int>(std::clamp<size_t>(kMostBytes / bytesOfRow, 1, kMostRows));
    for (int y = window.min.y; y <= window.max.y; y += rowCount) {
        const int last = std::min(window.max.y, y + rowCount - 1);
        const auto rows = static_cast<size_t>(int64_t{last} - window.min.y + 1);
        resize(picture, size.width * rows);
        file.setFrameBuffer(frameBuffer(picture, window));
        file.readPixels(y, last);
    }
    return picture;
}

} // namespace

void writeExr(const std::filesystem::path& path, const Picture& picture) {
    const size_t pixels = picture.color.pixels.size();
    CALOTYPE_CHECK_LT(0u, pixels);
    for (const Channel& channel : picture.channels)
        CALOTYPE_CHECK_EQ(
            std::visit([](const auto& values) { return values.size(); }, channel.pixels), pixels);
    const Imf::Header header = describe(picture);
    MemoryStream stream;
    {
        Imf::OutputFile file(stream, header);
        // OpenEXR needs pointers to mutable memory even if it only reads.
        file.setFrameBuffer(frameBuffer(const_cast<Picture&>(picture), header.dataWindow()));
        file.writePixels(static_cast<int>(picture.color.height));
    }
    writeFileAtomically(path, stream.bytes());
}

Image readExr(const std::filesystem::path& path) {
    return withExrErrors(path, [&] { return readPicture(path, false).color; });
}

bool hasOtherPrimaries(const std::filesystem::path& path) {
    return withExrErrors(path, [&] {
        checkExr(path);
        const Imf::InputFile file(path.c_str());
        const Imf::Header& header = file.header();
        if (!Imf::hasChromaticities(header)) // then they are those of Rec. 709
            return false;
        constexpr float kRounding = 1e-3f;
        const Imf::Chromaticities& named = Imf::chromaticities(header);
        const Imf::Chromaticities ours;
        return !(named.red.equalWithAbsError(ours.red, kRounding) &&
                 named.green.equalWithAbsError(ours.green, kRounding) &&
                 named.blue.equalWithAbsError(ours.blue, kRounding) &&
                 named.white.equalWithAbsError(ours.white, kRounding));
    });
}

std::vector<Attribute> readExrMetadata(const std::filesystem::path& path) {
    return withExrErrors(path, [&] {
        checkExr(path);
        return metadataOf(Imf::InputFile(path.c_str()).header());
    });
}

Picture readExrPicture(const std::filesystem::path& path) {
    return withExrErrors(path, [&] { return readPicture(path, true); });
}

} // namespace calotype
