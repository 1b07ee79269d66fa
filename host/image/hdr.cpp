#include "image/hdr.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "image/byte_order.h"
#include "image/check_size.h"

namespace calotype {
namespace {

constexpr size_t kRgbeBytes = 4; // red, green, blue, exponent
/// Rows of this length or longer may be run-length encoded.
constexpr uint32_t kShortestEncoded = 8;
constexpr uint32_t kLongestEncoded = 32767;

class HdrReader {
public:
    HdrReader(std::string_view file, const std::string& where) : rest_(file), where_(where) {}

    TexelImage read(uint32_t largestSide) {
        readHeader();
        TexelImage image;
        const auto [width, height] = readSize();
        checkSize({width, height}, largestSide, where_);
        image.width = width;
        image.height = height;
        if (rest_.size() < fewestBytes(width) * height)
            failCut();
        image.floats.reserve(image.texelCount() * kRgbeBytes);
        std::vector<unsigned char> row(size_t{width} * kRgbeBytes);
        for (uint32_t y = 0; y < height; ++y) {
            readRow(row);
            for (size_t i = 0; i < row.size(); i += kRgbeBytes)
                appendTexel(image.floats, &row[i]);
        }
        return image;
    }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw SceneError(where_, "the HDR picture " + message);
    }
    [[noreturn]] void failCut() const { fail("is incomplete: its end is missing"); }

    /// The least number of bytes of a row.
    static uint64_t fewestBytes(uint32_t width) {
        constexpr uint64_t kLongestRun = 127;
        return width < kShortestEncoded ? width * kRgbeBytes
                                        : 4 + kRgbeBytes * 2 * ((width - 1) / kLongestRun + 1);
    }

    std::string_view line() {
        const size_t end = rest_.find('\n');
        if (end == std::string_view::npos)
            failCut();
        const std::string_view result = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return result;
    }

    void readHeader() {
        bool isRgbe = true; // the default
        for (std::string_view text = line(); !text.empty(); text = line())
            if (text.starts_with("FORMAT="))
                isRgbe = text.starts_with("FORMAT=32-bit_rle_rgbe");
        if (!isRgbe)
            fail("holds XYZ colours, which cannot be read; convert it to RGBE");
    }

    uint32_t readSide(std::string_view& text, std::string_view axis) const {
        uint32_t side = 0;
        if (!text.starts_with(axis))
            fail("stores its rows in an order that cannot be read; only \"-Y HEIGHT +X WIDTH\" "
                 "can");
        text.remove_prefix(axis.size());
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
        if (error != std::errc())
            fail("has no valid size");
        text.remove_prefix(static_cast<size_t>(end - text.data()));
        return side;
    }

    std::pair<uint32_t, uint32_t> readSize() {
        std::string_view text = line();
        const uint32_t height = readSide(text, "-Y ");
        const uint32_t width = readSide(text, " +X ");
        return {width, height};
    }

    unsigned char byte() {
        if (rest_.empty())
            failCut();
        const auto value = static_cast<unsigned char>(rest_.front());
        rest_.remove_prefix(1);
        return value;
    }

    void readRow(std::vector<unsigned char>& row) {
        const size_t width = row.size() / kRgbeBytes;
        const bool encoded = width >= kShortestEncoded && width <= kLongestEncoded &&
                             rest_.starts_with("\x02\x02") && rest_.size() >= 4 &&
                             (byteAt(rest_, 2) << 8 | byteAt(rest_, 3)) == width;
        if (!encoded) {
            if (rest_.size() < row.size())
                failCut();
            rest_.copy(reinterpret_cast<char*>(row.data()), row.size());
            rest_.remove_prefix(row.size());
            return;
        }
        rest_.remove_prefix(4);
        for (size_t channel = 0; channel < kRgbeBytes; ++channel)
            readRuns(row, channel, width);
    }

    void readRuns(std::vector<unsigned char>& row, size_t channel, size_t width) {
        for (size_t x = 0; x < width;) {
            constexpr size_t kRunFlag = 128;
            size_t count = byte();
            const bool repeats = count > kRunFlag;
            count -= repeats ? kRunFlag : 0;
            if (count == 0 || count > width - x)
                fail("is corrupt: a run of pixels does not fit its row");
            const unsigned char repeated = repeats ? byte() : 0;
            for (; count > 0; --count, ++x)
                row[x * kRgbeBytes + channel] = repeats ? repeated : byte();
        }
    }

    static void appendTexel(std::vector<float>& floats, const unsigned char* rgbe) {
        constexpr int kBias = 128 + 8;
        const float unit = rgbe[3] == 0 ? 0.0f : std::ldexp(1.0f, rgbe[3] - kBias);
        for (int i = 0; i < 3; ++i)
            floats.push_back(static_cast<float>(rgbe[i]) * unit);
        floats.push_back(1.0f);
    }

    std::string_view rest_;
    const std::string& where_;
};

} // namespace

bool isHdr(std::string_view file) {
    return file.starts_with("#?RADIANCE") || file.starts_with("#?RGBE");
}

TexelImage readHdr(std::string_view file, uint32_t largestSide, const std::string& where) {
    return HdrReader(file, where).read(largestSide);
}

} // namespace calotype
