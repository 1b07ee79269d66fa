#include "film/feature_chunks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <stdexcept>

#include <zlib.h>

#include "base/check.h"

namespace calotype {
namespace {

constexpr size_t kChunkFloats = size_t{1} << 18;
constexpr size_t kFloatBytes = sizeof(float);

/// R, G and B of the first pixel, of the second, ...
template <typename Float, typename Pixels>
std::span<Float> floatsOf(Pixels& pixels) {
    static_assert(sizeof(pixels.front()) == 3 * kFloatBytes);
    return {pixels.empty() ? nullptr : &pixels.front()[0], 3 * pixels.size()};
}

std::string compress(std::span<const float> floats) {
    std::string planes(floats.size() * kFloatBytes, '\0');
    for (size_t i = 0; i < floats.size(); ++i)
        for (size_t byte = 0; byte < kFloatBytes; ++byte)
            planes[byte * floats.size() + i] =
                static_cast<char>(std::bit_cast<uint32_t>(floats[i]) >> 8 * byte);
    uLongf size = compressBound(planes.size());
    std::string compressed(size, '\0');
    const int result =
        compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
                  reinterpret_cast<const Bytef*>(planes.data()), planes.size(), Z_BEST_SPEED);
    CALOTYPE_CHECK_EQ(result, Z_OK);
    compressed.resize(size);
    return compressed;
}

void decompress(std::string_view compressed, std::span<float> floats) {
    std::string planes(floats.size() * kFloatBytes, '\0');
    uLongf size = planes.size();
    if (uncompress(reinterpret_cast<Bytef*>(planes.data()), &size,
                   reinterpret_cast<const Bytef*>(compressed.data()), compressed.size()) != Z_OK ||
        size != planes.size())
        throw std::out_of_range("features");
    for (size_t i = 0; i < floats.size(); ++i) {
        uint32_t bits = 0;
        for (size_t byte = 0; byte < kFloatBytes; ++byte)
            bits |= uint32_t{static_cast<unsigned char>(planes[byte * floats.size() + i])}
                    << 8 * byte;
        floats[i] = std::bit_cast<float>(bits);
        if (!std::isfinite(floats[i]))
            throw std::out_of_range("features");
    }
}

} // namespace

std::vector<std::string> compressedChunks(const DenoiserFeatures& features) {
    std::vector<std::string> chunks;
    for (const Image* image : {&features.albedo, &features.normal}) {
        const auto floats = floatsOf<const float>(image->pixels);
        for (size_t first = 0; first < floats.size(); first += kChunkFloats)
            chunks.push_back(
                compress(floats.subspan(first, std::min(kChunkFloats, floats.size() - first))));
    }
    return chunks;
}

DenoiserFeatures featuresFrom(const std::vector<std::string_view>& chunks, uint32_t width,
                              uint32_t height) {
    DenoiserFeatures features{Image(width, height), Image(width, height)};
    auto chunk = chunks.begin();
    for (Image* image : {&features.albedo, &features.normal}) {
        const auto floats = floatsOf<float>(image->pixels);
        for (size_t first = 0; first < floats.size(); first += kChunkFloats, ++chunk) {
            if (chunk == chunks.end())
                throw std::out_of_range("features");
            decompress(*chunk,
                       floats.subspan(first, std::min(kChunkFloats, floats.size() - first)));
        }
    }
    if (chunk != chunks.end())
        throw std::out_of_range("features");
    return features;
}

} // namespace calotype
