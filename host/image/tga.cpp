#include "image/tga.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/error.h"
#include "image/byte_order.h"

namespace calotype {
namespace {

constexpr size_t kTgaHeaderBytes = 18;
constexpr size_t kLongestRun = 128;

/// Image types, without the bit of run-length encoding.
enum TgaType : uint32_t { kIndexed = 1, kColor = 2, kGrey = 3 };

struct TgaHeader {
    explicit TgaHeader(std::string_view file)
        : hasColorMap(byteAt(file, 1) != 0), type(byteAt(file, 2) & 7u),
          isEncoded((byteAt(file, 2) & 8u) != 0), firstIndex(littleEndian16(file, 3)),
          mapLength(littleEndian16(file, 5)), mapBits(byteAt(file, 7)),
          size{littleEndian16(file, 12), littleEndian16(file, 14)}, bits(byteAt(file, 16)),
          alphaBits(byteAt(file, 17) & 15u), startsRight((byteAt(file, 17) & 16u) != 0),
          startsAtTop((byteAt(file, 17) & 32u) != 0), isInterleaved((byteAt(file, 17) & 192u) != 0),
          colorMap(kTgaHeaderBytes + byteAt(file, 0)) {}

    size_t mapBytes() const { return hasColorMap ? mapLength * ((mapBits + 7) / 8) : 0; }
    size_t pixels() const { return colorMap + mapBytes(); }

    bool hasColorMap;
    uint32_t type;
    bool isEncoded;
    uint32_t firstIndex; ///< of the colour map
    size_t mapLength;    ///< colours in the file
    size_t mapBits;      ///< of a colour of the map
    ImageSize size;
    size_t bits;        ///< of a pixel
    uint32_t alphaBits; ///< of a pixel
    bool startsRight;
    bool startsAtTop;
    bool isInterleaved;
    size_t colorMap; ///< where it starts
};

bool isOneOf(size_t value, std::initializer_list<size_t> allowed) {
    return std::ranges::find(allowed, value) != allowed.end();
}

/// What the extension area says about alpha.
enum class AlphaMeaning { Stated, None, Multiplied };

/// An extension area, if there is one, is found by the footer.
AlphaMeaning alphaMeaningOf(std::string_view file) {
    constexpr size_t kFooterBytes = 26;
    constexpr size_t kExtensionBytes = 495;
    constexpr std::string_view kFooterEnd("TRUEVISION-XFILE.\0", 18);
    if (file.size() < kTgaHeaderBytes + kFooterBytes || !file.ends_with(kFooterEnd))
        return AlphaMeaning::Stated;
    const size_t extension = littleEndian32(file, file.size() - kFooterBytes);
    if (extension == 0 || extension + kExtensionBytes > file.size())
        return AlphaMeaning::Stated;
    switch (byteAt(file, extension + kExtensionBytes - 1)) {
    case 0: // no alpha
    case 1: // undefined, may be ignored
    case 2: // undefined, to be kept
        return AlphaMeaning::None;
    case 4:
        return AlphaMeaning::Multiplied;
    default:
        return AlphaMeaning::Stated;
    }
}

using Rgba = std::array<uint8_t, kTexelChannels>;

class TgaReader {
public:
    TgaReader(std::string_view file, const std::string& where)
        : where_(where), header_(file), rest_(file.substr(std::min(file.size(), header_.pixels()))),
          meaning_(alphaMeaningOf(file)),
          hasAlpha_(header_.alphaBits > 0 && meaning_ != AlphaMeaning::None) {
        if (file.size() < header_.pixels())
            failCut();
        if (header_.type == kIndexed)
            readColorMap(file.substr(header_.colorMap, header_.mapBytes()));
    }

    TexelImage read(uint32_t largestSide) {
        const auto [width, height] = header_.size;
        checkSize(header_.size, largestSide, where_);
        requireKnownKind();
        TexelImage image;
        image.width = width;
        image.height = height;
        image.isEncoded = true;
        if (rest_.size() < fewestBytes(image.texelCount()))
            failCut();
        image.bytes.resize(kTexelChannels * image.texelCount());
        for (uint32_t row = 0; row < height; ++row) {
            const size_t y = header_.startsAtTop ? row : height - 1 - row;
            for (uint32_t column = 0; column < width; ++column) {
                const size_t x = header_.startsRight ? width - 1 - column : column;
                const Rgba texel = colorOf(nextPixel());
                image.isTransparent = image.isTransparent || texel[3] < 255;
                std::ranges::copy(texel, &image.bytes[kTexelChannels * (y * width + x)]);
            }
        }
        return image;
    }

private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw SceneError(where_, "the TGA " + problem);
    }
    [[noreturn]] void failCut() const { fail("is incomplete: its end is missing"); }

    void requireKnownKind() const {
        if (header_.isInterleaved)
            fail("stores its rows interleaved, which cannot be read; save it without");
        if (header_.type == kGrey && header_.bits == 16 && header_.alphaBits == 0)
            fail("is grey of 16 bits without alpha, which cannot be read; save it with 8 bits");
    }

    size_t bytesPerPixel() const { return (header_.bits + 7) / 8; }

    uint64_t fewestBytes(uint64_t pixels) const {
        return header_.isEncoded ? (pixels + kLongestRun - 1) / kLongestRun * (1 + bytesPerPixel())
                                 : pixels * bytesPerPixel();
    }

    void readColorMap(std::string_view bytes) {
        const size_t entry = (header_.mapBits + 7) / 8;
        for (size_t i = 0; i < header_.mapLength; ++i)
            colorMap_.push_back(directColor(bytes.substr(i * entry, entry), header_.mapBits));
    }

    std::string_view take(size_t bytes) {
        if (rest_.size() < bytes)
            failCut();
        const std::string_view taken = rest_.substr(0, bytes);
        rest_.remove_prefix(bytes);
        return taken;
    }

    std::string_view nextPixel() {
        if (!header_.isEncoded)
            return take(bytesPerPixel());
        if (packetLeft_ == 0) {
            const uint32_t packet = byteAt(take(1), 0);
            packetLeft_ = (packet & 127u) + 1;
            packetRepeats_ = (packet & 128u) != 0;
            if (packetRepeats_)
                repeated_ = take(bytesPerPixel());
        }
        --packetLeft_;
        return packetRepeats_ ? repeated_ : take(bytesPerPixel());
    }

    Rgba colorOf(std::string_view pixel) const {
        if (header_.type == kColor)
            return directColor(pixel, header_.bits);
        if (header_.type == kGrey) {
            const auto grey = static_cast<uint8_t>(pixel[0]);
            return withAlpha(grey, grey, grey, pixel.size() > 1 ? byteAt(pixel, 1) : 255);
        }
        const uint32_t index = pixel.size() > 1 ? littleEndian16(pixel, 0) : byteAt(pixel, 0);
        if (index < header_.firstIndex || index - header_.firstIndex >= colorMap_.size())
            fail("is corrupt: a pixel has a number that its colour map does not have");
        return colorMap_[index - header_.firstIndex];
    }

    /// Blue comes first: 5 bits each and one of alpha, or a byte each.
    Rgba directColor(std::string_view pixel, size_t bits) const {
        if (bits <= 8) {
            const auto grey = static_cast<uint8_t>(pixel[0]);
            return {grey, grey, grey, 255};
        }
        if (bits <= 16) {
            const uint32_t word = littleEndian16(pixel, 0);
            const auto fiveBits = [&](int shift) {
                return ((word >> shift & 31u) * 255 + 15) / 31;
            };
            return withAlpha(fiveBits(10), fiveBits(5), fiveBits(0),
                             bits == 16 && word >> 15 == 0 ? 0 : 255);
        }
        return withAlpha(byteAt(pixel, 2), byteAt(pixel, 1), byteAt(pixel, 0),
                         bits == 32 ? byteAt(pixel, 3) : 255);
    }

    Rgba withAlpha(uint32_t red, uint32_t green, uint32_t blue, uint32_t alpha) const {
        if (!hasAlpha_)
            alpha = 255;
        const auto channel = [&](uint32_t value) {
            if (meaning_ == AlphaMeaning::Multiplied && alpha > 0)
                value = std::min(255u, (value * 255 + alpha / 2) / alpha);
            return static_cast<uint8_t>(value);
        };
        return {channel(red), channel(green), channel(blue), static_cast<uint8_t>(alpha)};
    }

    const std::string& where_;
    TgaHeader header_;
    std::string_view rest_;
    AlphaMeaning meaning_;
    bool hasAlpha_;
    std::vector<Rgba> colorMap_;
    uint32_t packetLeft_ = 0; ///< pixels of the current run-length packet
    bool packetRepeats_ = false;
    std::string_view repeated_;
};

} // namespace

bool isTga(std::string_view file) {
    if (file.size() < kTgaHeaderBytes || byteAt(file, 1) > 1 || (byteAt(file, 2) & ~8u) > kGrey)
        return false;
    const TgaHeader header(file);
    if (header.hasColorMap && !isOneOf(header.mapBits, {8, 15, 16, 24, 32}))
        return false;
    switch (header.type) {
    case kIndexed:
        return header.hasColorMap && isOneOf(header.bits, {8, 16});
    case kColor:
        return isOneOf(header.bits, {15, 16, 24, 32});
    case kGrey:
        return isOneOf(header.bits, {8, 16});
    default:
        return false;
    }
}

ImageSize sizeOfTga(std::string_view file) { return TgaHeader(file).size; }

TexelImage readTga(std::string_view file, uint32_t largestSide, const std::string& where) {
    return TgaReader(file, where).read(largestSide);
}

} // namespace calotype
