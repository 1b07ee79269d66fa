#include "image/hdr.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "image/byte_order.h"
#include "image/hdr_header.h"

namespace calotype {
namespace {

constexpr size_t kRgbeBytes = 4; // red, green, blue, exponent
/// Rows of this length or longer may be run-length encoded by channels.
constexpr size_t kShortestEncoded = 8;
constexpr size_t kLongestEncoded = 32767;

using Rgbe = std::array<unsigned char, kRgbeBytes>;

/// Rows are the lines of the file, which may be columns of the picture.
class HdrReader {
public:
    HdrReader(std::string_view file, const std::string& where)
        : where_(where), header_(readHdrHeader(file, where)), rest_(file) {}

    TexelImage read(uint32_t largestSide) {
        checkSize(header_.size, largestSide, where_);
        TexelImage image;
        image.width = header_.size.width;
        image.height = header_.size.height;
        if (rest_.size() < fewestBytes(header_.rowLength()) * header_.rowCount())
            failCut();
        image.floats.resize(image.texelCount() * kTexelChannels);
        std::vector<Rgbe> row(header_.rowLength());
        for (uint32_t i = 0; i < header_.rowCount(); ++i) {
            readRow(row);
            for (uint32_t j = 0; j < row.size(); ++j)
                storeTexel(&image.floats[kTexelChannels * header_.texelAt(i, j)], row[j]);
        }
        return image;
    }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw SceneError(where_, "the HDR picture " + message);
    }
    [[noreturn]] void failCut() const { fail("is incomplete: its end is missing"); }
    [[noreturn]] void failRun() const { fail("is corrupt: a run of pixels does not fit its row"); }

    /// The least number of bytes of a row: of one pixel and repetitions of up to 2^8 and 2^16.
    static uint64_t fewestBytes(uint32_t length) {
        return kRgbeBytes * (length == 1 ? 1 : length <= 256 ? 2 : 3);
    }

    unsigned char byte() {
        if (rest_.empty())
            failCut();
        const auto value = static_cast<unsigned char>(rest_.front());
        rest_.remove_prefix(1);
        return value;
    }

    void readRow(std::vector<Rgbe>& row) {
        const bool isEncoded = row.size() >= kShortestEncoded && row.size() <= kLongestEncoded &&
                               rest_.size() >= kRgbeBytes && rest_.starts_with("\x02\x02") &&
                               byteAt(rest_, 2) < 128;
        if (!isEncoded)
            return readPixels(row);
        if ((byteAt(rest_, 2) << 8 | byteAt(rest_, 3)) != row.size())
            fail("is corrupt: a row states another length than the header");
        rest_.remove_prefix(kRgbeBytes);
        for (size_t channel = 0; channel < kRgbeBytes; ++channel)
            readRuns(row, channel);
    }

    /// Pixels in full. One of mantissas 1, 1, 1, which no colour has, repeats the one before: as
    /// often as its exponent states, times 256 for each such pixel just before (Radiance 1.3 and
    /// older).
    void readPixels(std::vector<Rgbe>& row) {
        uint64_t scale = 1;
        for (size_t x = 0; x < row.size();) {
            Rgbe pixel;
            for (unsigned char& value : pixel)
                value = byte();
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                row[x++] = pixel;
                scale = 1;
                continue;
            }
            const uint64_t count = pixel[3] * scale;
            if (x == 0 || count > row.size() - x)
                failRun();
            std::fill_n(row.begin() + static_cast<ptrdiff_t>(x), count, row[x - 1]);
            x += count;
            scale = std::min(scale * 256, uint64_t{1} << 32); // longer than any row
        }
    }

    void readRuns(std::vector<Rgbe>& row, size_t channel) {
        for (size_t x = 0; x < row.size();) {
            constexpr size_t kRunFlag = 128;
            size_t count = byte();
            const bool repeats = count > kRunFlag;
            count -= repeats ? kRunFlag : 0;
            if (count == 0 || count > row.size() - x)
                failRun();
            const unsigned char repeated = repeats ? byte() : 0;
            for (; count > 0; --count, ++x)
                row[x][channel] = repeats ? repeated : byte();
        }
    }

    void storeTexel(float* texel, const Rgbe& rgbe) const {
        constexpr int kBias = 128 + 8;
        const double unit = rgbe[3] == 0 ? 0.0 : std::ldexp(1.0, rgbe[3] - kBias);
        for (int i = 0; i < 3; ++i) {
            texel[i] = static_cast<float>(rgbe[i] * unit / header_.correction[i]);
            if (!std::isfinite(texel[i]))
                fail("has values beyond the range of float after division by its EXPOSURE");
        }
        texel[3] = 1.0f;
    }

    const std::string& where_;
    HdrHeader header_;
    std::string_view rest_;
};

} // namespace

bool isHdr(std::string_view file) {
    return file.starts_with("#?RADIANCE") || file.starts_with("#?RGBE");
}

TexelImage readHdr(std::string_view file, uint32_t largestSide, const std::string& where) {
    return HdrReader(file, where).read(largestSide);
}

ImageSize sizeOfHdr(std::string_view file, const std::string& where) {
    return readHdrHeader(file, where).size;
}

} // namespace calotype
