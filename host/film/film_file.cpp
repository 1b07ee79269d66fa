#include "film/film_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <exception>
#include <fstream>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/content_hash.h"
#include "base/error.h"
#include "base/file_kind.h"
#include "base/hexadecimal.h"
#include "base/parallel_for.h"
#include "base/read_file.h"
#include "film/feature_chunks.h"
#include "image/byte_order.h"

// A film's file, all numbers little-endian:
//
//     0   "CALOFILM"
//     8   version of the format, 32 bits
//     12  bytes of the description, 32 bits
//     16  checksum of all that follows, 64 bits
//     24  description: JSON
//         R, G and B of the first pixel, of the second, ...; then the luminances of replica 0, 1,
//         ...; in version 2 then R, G and B of all pixels for replica 0, 1, ...; numbers of 128
//         bits in chunks of 65,536: the first bytes of all numbers of the chunk, then their second
//         bytes, ...; compressed by zlib
//         in version 2, if the description has their "feature_bytes": the features of denoisers
//         (film/feature_chunks.h)
//
// Version 3 is for films whose background is hidden from the camera: the colours of replicas are
// there if the description has "replica_colors" true, and before the features are the numbers of
// hidden samples of all pixels.
namespace calotype {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kMagic = "CALOFILM";
constexpr uint32_t kVersion = 1;
constexpr uint32_t kVersionWithColors = 2; ///< of replicas
constexpr uint32_t kVersionWithAlpha = 3;
constexpr size_t kDescriptionAt = 24;
constexpr size_t kChunkNumbers = 65536;
constexpr size_t kNumberBytes = sizeof(FixedPoint);

template <typename Number>
void append(std::string& bytes, Number number) {
    for (size_t i = 0; i < sizeof number; ++i)
        bytes += static_cast<char>(number >> 8 * i);
}

uint64_t littleEndian64(std::string_view bytes, size_t at) {
    return littleEndian32(bytes, at) | uint64_t{littleEndian32(bytes, at + 4)} << 32;
}

/// Of the pieces together.
uint64_t checksumOf(std::span<const std::string_view> pieces) {
    ContentHash hash;
    hash.add(pieces);
    return hash.value();
}

/// A chunk of the file: consecutive numbers of one of the film's arrays.
template <typename Array>
struct FileChunk {
    Array* array;
    size_t first;
    size_t count;
};

/// All chunks, in the order of the file. No two of them share a chunk of an array.
template <typename Array, typename Sums>
std::vector<FileChunk<Array>> chunksOf(Sums& sums) {
    static_assert(kChunkNumbers % FixedPointArray::kChunkNumbers == 0);
    std::vector<FileChunk<Array>> chunks;
    for (Array* array : {&sums.colors, &sums.luminances, &sums.replicaColors, &sums.hiddenSamples})
        for (size_t first = 0; first < array->size(); first += kChunkNumbers)
            chunks.push_back({array, first, std::min(kChunkNumbers, array->size() - first)});
    return chunks;
}

/// Memory of one thread that all of its chunks use, so that the heap is not cut into pieces.
struct Scratch {
    std::vector<FixedPoint> numbers;
    std::string planes;
    std::string compressed;
};

std::string compress(const FileChunk<const FixedPointArray>& chunk, Scratch& scratch) {
    auto& [numbers, planes, compressed] = scratch;
    numbers.resize(chunk.count);
    chunk.array->read(chunk.first, numbers);
    planes.resize(numbers.size() * kNumberBytes);
    for (size_t i = 0; i < numbers.size(); ++i)
        for (size_t byte = 0; byte < kNumberBytes; ++byte)
            planes[byte * numbers.size() + i] = static_cast<char>(numbers[i] >> 8 * byte);
    uLongf size = compressBound(planes.size());
    compressed.resize(size);
    const int result =
        compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
                  reinterpret_cast<const Bytef*>(planes.data()), planes.size(), Z_BEST_SPEED);
    CALOTYPE_CHECK_EQ(result, Z_OK);
    return compressed.substr(0, size);
}

/// False where the bytes do not hold that many numbers.
bool decompress(std::string_view compressed, const FileChunk<FixedPointArray>& chunk) {
    std::vector<FixedPoint> numbers(chunk.count);
    std::string planes(numbers.size() * kNumberBytes, '\0');
    uLongf size = planes.size();
    if (uncompress(reinterpret_cast<Bytef*>(planes.data()), &size,
                   reinterpret_cast<const Bytef*>(compressed.data()), compressed.size()) != Z_OK ||
        size != planes.size())
        return false;
    for (size_t i = 0; i < numbers.size(); ++i) {
        unsigned __int128 bits = 0;
        for (size_t byte = 0; byte < kNumberBytes; ++byte)
            bits |= static_cast<unsigned __int128>(
                        static_cast<unsigned char>(planes[byte * numbers.size() + i]))
                    << 8 * byte;
        numbers[i] = static_cast<FixedPoint>(bits);
    }
    chunk.array->write(chunk.first, numbers);
    return true;
}

uint32_t versionOf(const Film& film) {
    if (film.hasAlpha())
        return kVersionWithAlpha;
    return film.detail() == ReplicaDetail::Color ? kVersionWithColors : kVersion;
}

Json sizesOf(const std::vector<std::string>& chunks) {
    Json sizes = Json::array();
    for (const std::string& chunk : chunks)
        sizes.push_back(chunk.size());
    return sizes;
}

Json describe(const FilmLabel& label, const Film& film, const std::vector<std::string>& chunks,
              const std::vector<std::string>& featureChunks) {
    Json blocks = Json::array();
    for (const BlockRange& range : film.blocks().ranges())
        blocks.push_back({range.begin, range.end});
    const FilmLosses& losses = film.losses();
    Json description = {{"scene_hash", hexadecimal(label.sceneHash)},
                        {"settings", label.settings},
                        {"devices", label.devices},
                        {"width", film.width()},
                        {"height", film.height()},
                        {"unit_exponent", std::ilogb(film.unit())},
                        {"blocks", blocks},
                        {"non_finite_samples", losses.nonFiniteSamples},
                        {"cut_paths", losses.cutPaths},
                        {"non_finite_pixels", losses.nonFinitePixels},
                        {"overflowed_pixels", losses.overflowedPixels},
                        {"chunk_bytes", sizesOf(chunks)}};
    if (film.hasAlpha())
        description["replica_colors"] = film.detail() == ReplicaDetail::Color;
    if (!label.camera.empty())
        description["camera"] = label.camera;
    if (!featureChunks.empty())
        description["feature_bytes"] = sizesOf(featureChunks);
    return description;
}

/// Throws if `number` is not an integer from `least` to `most`.
template <typename Number>
Number numberIn(const Json& number, Number least, Number most) {
    const bool isInRange = number.is_number_unsigned()
                               ? std::cmp_less_equal(number.get<uint64_t>(), most) &&
                                     std::cmp_less_equal(least, number.get<uint64_t>())
                               : number.is_number_integer() &&
                                     std::cmp_less_equal(number.get<int64_t>(), most) &&
                                     std::cmp_less_equal(least, number.get<int64_t>());
    if (!isInRange)
        throw std::out_of_range(number.dump());
    return number.get<Number>();
}

/// Throws if the ranges do not have the form that writeFilm writes.
BlockRanges readBlocks(const Json& description) {
    BlockRanges blocks;
    uint32_t end = 0;
    for (const Json& range : description.at("blocks")) {
        const auto begin = numberIn<uint32_t>(range.at(0), end, Film::kMaxBlocks - 1);
        end = numberIn<uint32_t>(range.at(1), begin + 1, Film::kMaxBlocks);
        blocks.add({begin, end});
    }
    return blocks;
}

/// The next chunks of the file, of these sizes; removes them from its rest. Throws if it is
/// shorter.
std::vector<std::string_view> nextChunks(const Json& sizes, std::string_view& rest) {
    std::vector<std::string_view> chunks;
    for (const Json& size : sizes) {
        chunks.push_back(rest.substr(0, numberIn<uint64_t>(size, 0, rest.size())));
        rest.remove_prefix(chunks.back().size());
    }
    return chunks;
}

/// Whether each is a number of samples that films of these blocks can have.
bool areCounts(const FixedPointArray& numbers, const BlockRanges& blocks) {
    const auto most = static_cast<FixedPoint>(blocks.count()) * shared::kSamplesPerBlock;
    for (size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] < 0 || numbers[i] > most)
            return false;
    return true;
}

bool isOfAlpha(const FilmLabel& label) { return label.setting(kAlphaSetting) == "on"; }

/// Throws if the description and the chunks do not fit each other.
KeptFilm readParts(const Json& description, std::string_view compressed, uint32_t version) {
    const auto width = numberIn<uint32_t>(description.at("width"), 1, kLargestPictureSide);
    const auto height = numberIn<uint32_t>(description.at("height"), 1, kLargestPictureSide);
    const size_t allBytes = compressed.size();
    const auto chunks = nextChunks(description.at("chunk_bytes"), compressed);
    const size_t given = allBytes - compressed.size();
    const auto featureChunks =
        nextChunks(description.value("feature_bytes", Json::array()), compressed);
    const size_t pixels = size_t{width} * height;
    const size_t ofColors = pixels * Film::kChannels;
    const size_t ofLuminances = pixels * shared::kReplicas;
    const bool hasAlpha = version == kVersionWithAlpha;
    const bool hasReplicaColors =
        hasAlpha ? description.at("replica_colors").get<bool>() : version == kVersionWithColors;
    const size_t ofReplicaColors = hasReplicaColors ? ofColors * shared::kReplicas : 0;
    const size_t ofHiddenSamples = hasAlpha ? pixels : 0;
    const auto chunksFor = [](size_t n) { return (n + kChunkNumbers - 1) / kChunkNumbers; };
    if (chunks.size() != chunksFor(ofColors) + chunksFor(ofLuminances) +
                             chunksFor(ofReplicaColors) + chunksFor(ofHiddenSamples))
        throw std::out_of_range("chunks");
    // zlib expands a byte to at most 1032. A larger claim is refused before memory is allocated.
    constexpr size_t kMostPerByte = 1032;
    if ((ofColors + ofLuminances + ofReplicaColors + ofHiddenSamples) * kNumberBytes >
            kMostPerByte * given ||
        !compressed.empty())
        throw std::out_of_range("chunks");
    Film::Sums sums;
    sums.blocks = readBlocks(description);
    const auto count = [&](const char* name) {
        return numberIn<uint64_t>(description.at(name), 0, uint64_t{1} << 63);
    };
    sums.losses = {count("non_finite_samples"), count("cut_paths"), count("non_finite_pixels"),
                   count("overflowed_pixels")};
    sums.colors = FixedPointArray(ofColors);
    sums.luminances = FixedPointArray(ofLuminances);
    sums.replicaColors = FixedPointArray(ofReplicaColors);
    sums.hiddenSamples = FixedPointArray(ofHiddenSamples);
    const auto targets = chunksOf<FixedPointArray>(sums);
    std::atomic<bool> isWhole = true;
    parallelFor(0, targets.size(), allCores(), [&](uint64_t i, uint32_t) {
        if (!decompress(chunks[i], targets[i]))
            isWhole = false;
    });
    const auto exponent = numberIn<int>(description.at("unit_exponent"), -126, 127);
    if (!isWhole || !areCounts(sums.hiddenSamples, sums.blocks))
        throw std::out_of_range("sums");
    FilmLabel label;
    label.sceneHash = std::stoull(description.at("scene_hash").get<std::string>(), nullptr, 16);
    label.settings = description.at("settings");
    label.devices = description.at("devices");
    if (description.contains("camera")) // films of earlier programs lack it
        label.camera = description.at("camera");
    if (hasAlpha != isOfAlpha(label))
        throw std::out_of_range(kAlphaSetting);
    KeptFilm kept{label, Film(width, height, std::ldexp(1.0, exponent), std::move(sums))};
    if (!featureChunks.empty() && hasReplicaColors)
        kept.features = featuresFrom(featureChunks, width, height);
    return kept;
}

} // namespace

std::string FilmLabel::setting(const std::string& name) const {
    const auto found = settings.find(name);
    return found == settings.end() ? "none" : found->second;
}

void writeFilm(const std::filesystem::path& path, const FilmLabel& label, const Film& film,
               const std::optional<DenoiserFeatures>& features) {
    CALOTYPE_CHECK_EQ(!features || film.detail() == ReplicaDetail::Color, true);
    CALOTYPE_CHECK_EQ(film.hasAlpha(), isOfAlpha(label));
    const Film::Sums& sums = film.sums();
    const auto chunks = chunksOf<const FixedPointArray>(sums);
    std::vector<std::string> compressed(chunks.size());
    std::vector<Scratch> scratch(allCores());
    parallelFor(0, chunks.size(), allCores(), [&](uint64_t i, uint32_t thread) {
        compressed[i] = compress(chunks[i], scratch[thread]);
    });
    const auto ofFeatures = features ? compressedChunks(*features) : std::vector<std::string>();
    const std::string description = describe(label, film, compressed, ofFeatures).dump();
    // In pieces, since the chunks of a large picture take hundreds of megabytes.
    std::vector<std::string_view> pieces = {"", description};
    pieces.insert(pieces.end(), compressed.begin(), compressed.end());
    pieces.insert(pieces.end(), ofFeatures.begin(), ofFeatures.end());
    std::string start(kMagic);
    append(start, versionOf(film));
    append(start, static_cast<uint32_t>(description.size()));
    append(start, checksumOf(std::span(pieces).subspan(1)));
    pieces.front() = start;
    writeFileAtomically(path, pieces);
}

KeptFilm readFilm(const std::filesystem::path& path) {
    const std::string name = path.string();
    const std::string bytes = readFile(name, name);
    const std::string_view all = bytes;
    if (!all.starts_with(kMagic) || all.size() < kDescriptionAt) {
        const std::string_view kind =
            all.starts_with(kMagic) ? "the beginning of a film" : fileKind(all);
        throw SceneError(name, "the file is " + std::string(kind.empty() ? "no film" : kind) +
                                   "; films are written by calotype render --film");
    }
    const uint32_t version = littleEndian32(all, kMagic.size());
    if (version < kVersion || version > kVersionWithAlpha)
        throw SceneError(name, "the film is of format " + std::to_string(version) +
                                   ", and this Calotype reads formats " + std::to_string(kVersion) +
                                   " to " + std::to_string(kVersionWithAlpha));
    const std::string_view contents = all.substr(kDescriptionAt);
    const uint32_t descriptionBytes = littleEndian32(all, 12);
    if (checksumOf({&contents, 1}) != littleEndian64(all, 16) || descriptionBytes > contents.size())
        throw SceneError(name, "the film is damaged: its checksum is not that of its contents");
    try {
        return readParts(Json::parse(contents.substr(0, descriptionBytes)),
                         contents.substr(descriptionBytes), version);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) { // of the JSON library, or of a number out of range
        throw SceneError(name,
                         std::string("the film's description makes no sense: ") + error.what());
    }
}

bool isFilm(const std::filesystem::path& path) {
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown)) // reading from a pipe may never end
        return false;
    std::ifstream file(path, std::ios::binary);
    std::string start(kMagic.size(), '\0');
    return file.read(start.data(), static_cast<std::streamsize>(start.size())) && start == kMagic;
}

} // namespace calotype
