#include "image/exr_size.h"

#include <exception>
#include <string>
#include <vector>

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include "image/exr_check.h"

namespace calotype {
namespace {

constexpr std::string_view kSignature = "\x76\x2f\x31\x01";

ImageSize sizeOf(const Imath::Box2i& window) {
    const auto side = [](int first, int last) {
        return static_cast<uint32_t>(int64_t{last} - first + 1);
    };
    return {side(window.min.x, window.max.x), side(window.min.y, window.max.y)};
}

void readLastRow(Imf::InputFile& file, uint32_t width) {
    Imath::Box2i row = file.header().dataWindow();
    row.min.y = row.max.y;
    std::vector<float> red(width);
    Imf::FrameBuffer buffer;
    buffer.insert("R", Imf::Slice::Make(Imf::FLOAT, red.data(), row));
    file.setFrameBuffer(buffer);
    file.readPixels(row.max.y);
}

} // namespace

bool isExr(std::string_view file) { return file.starts_with(kSignature); }

ImageSize wholeExrSize(const std::filesystem::path& path, uint32_t largestSide) {
    try {
        checkExr(path);
        Imf::InputFile file(path.c_str());
        const ImageSize size = sizeOf(file.header().dataWindow());
        checkSize(size, largestSide, path.string());
        readLastRow(file, size.width);
        return size;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw SceneError(path.string(),
                         std::string("the EXR file cannot be read: ") + error.what());
    }
}

} // namespace calotype
