#include "image/layers.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "base/check.h"
#include "base/error.h"
#include "image/cryptomatte.h"
#include "image/exr.h"

namespace calotype {
namespace {

constexpr size_t kChannelBytes = 4;

/// Of values that lie kOffset bytes from the beginning of a record.
template <typename Value, size_t kOffset, size_t kRecordBytes>
Layer makeLayer(const char* name, LayerSource source, std::string_view channels, const char* help) {
    static_assert(kOffset + sizeof(Value) <= kRecordBytes);
    Layer layer{.name = name,
                .source = source,
                .channels = {},
                .isInteger = std::is_same_v<Value, uint32_t>,
                .help = help,
                .offset = kOffset};
    while (!channels.empty()) {
        const size_t end = std::min(channels.find(','), channels.size());
        layer.channels.push_back(layer.name + "." + std::string(channels.substr(0, end)));
        channels.remove_prefix(std::min(end + 1, channels.size()));
    }
    CALOTYPE_CHECK_EQ(layer.channels.size() * kChannelBytes, sizeof(Value));
    return layer;
}

Layer makeMatte(const char* name, MatteKind kind, const char* typeName, const char* help) {
    return {.name = name,
            .source = LayerSource::Mattes,
            .channels = cryptomatteChannels(typeName),
            .help = help,
            .typeName = typeName,
            .matte = kind};
}

std::vector<Layer> makeLayers() {
    using namespace shared; // the types of the table
#define CALOTYPE_MATTE_ROW(name, kind, typeName, help)                                             \
    makeMatte(#name, MatteKind::kind, typeName, help),
#define CALOTYPE_FIRST_HIT_ROW(name, type, nothing, channels, help)                                \
    makeLayer<type, offsetof(FirstHit, name), sizeof(FirstHit)>(#name, LayerSource::FirstHit,      \
                                                                channels, help),
#define CALOTYPE_AVERAGED_ROW(name, type, channels, help)                                          \
    makeLayer<type, offsetof(Features, name), sizeof(Features)>(#name, LayerSource::Averaged,      \
                                                                channels, help),
#define CALOTYPE_REPLICAS_ROW(name, first, type, channels, help)                                   \
    makeLayer<type, offsetof(PixelError, first), sizeof(PixelError)>(#name, LayerSource::Replicas, \
                                                                     channels, help),
    return {CALOTYPE_LAYERS(CALOTYPE_FIRST_HIT_ROW, CALOTYPE_AVERAGED_ROW, CALOTYPE_REPLICAS_ROW,
                            CALOTYPE_MATTE_ROW)};
}

/// The 32-bit number at `offset` bytes in each record.
template <typename Value, typename Record>
std::vector<Value> gather(std::span<const Record> records, size_t offset) {
    std::vector<Value> values(records.size());
    for (size_t i = 0; i < records.size(); ++i)
        std::memcpy(&values[i], reinterpret_cast<const char*>(&records[i]) + offset, sizeof(Value));
    return values;
}

/// The channels of a layer whose values are contiguous in each record.
template <typename Record>
std::vector<Channel> gatherChannels(const Layer& layer, std::span<const Record> records) {
    std::vector<Channel> channels;
    size_t offset = layer.offset;
    for (const std::string& name : layer.channels) {
        Channel& channel = channels.emplace_back(Channel{name, {}});
        if (layer.isInteger)
            channel.pixels = gather<uint32_t>(records, offset);
        else
            channel.pixels = gather<float>(records, offset);
        offset += kChannelBytes;
    }
    return channels;
}

/// Writes a channel into its field of each hit: the inverse of gather.
void scatter(const Channel& channel, size_t offset, FirstHitImage& hits) {
    std::visit(
        [&](const auto& values) {
            for (size_t i = 0; i < values.size(); ++i)
                std::memcpy(reinterpret_cast<char*>(&hits.pixels[i]) + offset, &values[i],
                            kChannelBytes);
        },
        channel.pixels);
}

} // namespace

LayerList allLayers() {
    static const std::vector<Layer> table = makeLayers();
    LayerList layers;
    for (const Layer& layer : table)
        layers.push_back(&layer);
    return layers;
}

LayerList layersOfFilms() {
    LayerList layers = allLayers();
    std::erase_if(layers,
                  [](const Layer* layer) { return layer->source != LayerSource::Replicas; });
    return layers;
}

const Layer* findLayer(std::string_view name) {
    for (const Layer* layer : allLayers())
        if (layer->name == name)
            return layer;
    return nullptr;
}

bool hasSource(const LayerList& layers, LayerSource source) {
    return std::ranges::any_of(layers, [&](const Layer* layer) { return layer->source == source; });
}

std::string namesOf(const LayerList& layers) {
    std::string names;
    for (const Layer* layer : layers)
        names += (names.empty() ? "" : ", ") + layer->name;
    return names;
}

std::vector<Channel> channelsOf(const Layer& layer, const FirstHitImage& hits) {
    CALOTYPE_CHECK_EQ(layer.source == LayerSource::FirstHit, true);
    return gatherChannels(layer, std::span(hits.pixels));
}

std::vector<Channel> channelsOf(const Layer& layer, const FeatureImage& features) {
    CALOTYPE_CHECK_EQ(layer.source == LayerSource::Averaged, true);
    return gatherChannels(layer, std::span(features.pixels));
}

std::vector<Channel> channelsOf(const Layer& layer, std::span<const PixelError> errors) {
    CALOTYPE_CHECK_EQ(layer.source == LayerSource::Replicas, true);
    return gatherChannels(layer, errors);
}

std::vector<Channel> channelsOf(const Layer& layer, const Coverage& coverage,
                                std::span<const float> ids) {
    CALOTYPE_CHECK_EQ(layer.source == LayerSource::Mattes, true);
    std::vector<Channel> channels;
    for (const std::string& name : layer.channels)
        channels.push_back({name, std::vector<float>(coverage.pixelCount())});
    for (size_t pixel = 0; pixel < coverage.pixelCount(); ++pixel) {
        const std::vector<Coverage::Share> shares = coverage.ranked(pixel);
        const size_t ranks = std::min(shares.size(), channels.size() / 2);
        for (size_t rank = 0; rank < ranks; ++rank) {
            std::get<0>(channels[2 * rank].pixels)[pixel] = ids[shares[rank].thing];
            std::get<0>(channels[2 * rank + 1].pixels)[pixel] = shares[rank].share;
        }
    }
    return channels;
}

FirstHitImage readFirstHits(const std::filesystem::path& path) {
    const Picture picture = readExrPicture(path);
    FirstHitImage hits(picture.color.width, picture.color.height);
    bool isFound = false;
    for (const Layer* layer : allLayers()) {
        if (layer->source != LayerSource::FirstHit)
            continue;
        for (size_t i = 0; i < layer->channels.size(); ++i) {
            const auto channel =
                std::ranges::find(picture.channels, layer->channels[i], &Channel::name);
            if (channel == picture.channels.end() ||
                std::holds_alternative<std::vector<uint32_t>>(channel->pixels) != layer->isInteger)
                continue;
            isFound = true;
            scatter(*channel, layer->offset + i * kChannelBytes, hits);
        }
    }
    if (!isFound)
        throw SceneError(path.string(),
                         "the file has no layer of first hits; render it with --aov");
    return hits;
}

} // namespace calotype
