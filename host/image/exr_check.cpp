#include "image/exr_check.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>

#include <OpenEXR/openexr.h>

#include "base/error.h"
#include "image/check_size.h"
#include "image/image.h"

namespace calotype {
namespace {

/// Twenty channels of float in blocks of 32 rows of the longest side, or in tiles of 1024 x 1024.
constexpr uint64_t kLargestChunk = uint64_t{256} << 20;
/// Of the table of chunks.
constexpr uint64_t kBytesPerOffset = 8;

/// Reads headers only: the functions of OpenEXR's core check all sizes against the file's.
class ExrHeader {
public:
    explicit ExrHeader(const std::filesystem::path& path) : where_(path.string()) {
        exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
        options.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
        options.flags = EXR_CONTEXT_FLAG_STRICT_HEADER;
        options.max_tile_width = kLargestPictureSide;
        options.max_tile_height = kLargestPictureSide;
        exr_context_t context = nullptr;
        const exr_result_t result = exr_start_read(&context, path.c_str(), &options);
        context_.reset(context);
        require(result);
    }

    [[noreturn]] void fail(const std::string& problem) const {
        throw SceneError(where_, "the EXR file cannot be read: " + problem);
    }

    bool isDeep() const {
        exr_storage_t storage = EXR_STORAGE_SCANLINE;
        require(exr_get_storage(context_.get(), kPart, &storage));
        return storage == EXR_STORAGE_DEEP_SCANLINE || storage == EXR_STORAGE_DEEP_TILED;
    }

    ImageSize size() const {
        exr_attr_box2i_t window{};
        require(exr_get_data_window(context_.get(), kPart, &window));
        const auto side = [](int32_t first, int32_t last) {
            return static_cast<uint32_t>(int64_t{last} - first + 1);
        };
        return {side(window.min.x, window.max.x), side(window.min.y, window.max.y)};
    }

    uint64_t chunkCount() const {
        int32_t count = 0;
        require(exr_get_chunk_count(context_.get(), kPart, &count));
        return static_cast<uint64_t>(std::max(count, 0));
    }

    /// In bytes, decompressed.
    uint64_t chunkSize() const { return chunkPixels() * bytesPerPixel(); }

private:
    static constexpr int kPart = 0; // the one that is read

    struct Finish {
        void operator()(exr_context_t context) const { exr_finish(&context); }
    };

    void require(exr_result_t result) const {
        if (result != EXR_ERR_SUCCESS)
            fail(exr_get_default_error_message(result));
    }

    uint64_t chunkPixels() const {
        exr_storage_t storage = EXR_STORAGE_SCANLINE;
        require(exr_get_storage(context_.get(), kPart, &storage));
        if (storage == EXR_STORAGE_TILED) {
            uint32_t width = 0;
            uint32_t height = 0;
            exr_tile_level_mode_t level{};
            exr_tile_round_mode_t round{};
            require(
                exr_get_tile_descriptor(context_.get(), kPart, &width, &height, &level, &round));
            return uint64_t{width} * height;
        }
        int32_t rows = 0;
        require(exr_get_scanlines_per_chunk(context_.get(), kPart, &rows));
        return uint64_t{size().width} * static_cast<uint64_t>(rows);
    }

    uint64_t bytesPerPixel() const {
        const exr_attr_chlist_t* channels = nullptr;
        require(exr_get_channels(context_.get(), kPart, &channels));
        uint64_t bytes = 0;
        for (int i = 0; i < channels->num_channels; ++i)
            bytes += channels->entries[i].pixel_type == EXR_PIXEL_HALF ? 2 : 4;
        return bytes;
    }

    std::string where_;
    std::unique_ptr<_priv_exr_context_t, Finish> context_;
};

} // namespace

bool isExr(std::string_view file) { return file.starts_with("\x76\x2f\x31\x01"); }

ImageSize checkExr(const std::filesystem::path& path) {
    const ExrHeader header(path);
    checkSize(header.size(), kLargestPictureSide, path.string());
    if (header.isDeep())
        header.fail("its pixels are deep; flatten it first");
    if (header.chunkSize() > kLargestChunk)
        header.fail("a chunk of it takes more than 256 MiB; write it in smaller tiles or rows");
    if (header.chunkCount() > std::filesystem::file_size(path) / kBytesPerOffset)
        header.fail("its end is missing");
    return header.size();
}

} // namespace calotype
