#include "image/exr_layers.h"

#include <cstddef>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include "image/exr_check.h"
#include "image/exr_error.h"

namespace calotype {

const std::array<std::string, 6> kFirstHitLayerNames = {"albedo",   "normal",    "depth",
                                                        "position", "primitive", "uv"};

namespace {

struct LayerChannel {
    FirstHitLayer layer;
    const char* name;
    size_t offset; ///< in a FirstHit, bytes
};

constexpr LayerChannel kLayerChannels[] = {
    {FirstHitLayer::Albedo, "R", offsetof(FirstHit, albedo)},
    {FirstHitLayer::Albedo, "G", offsetof(FirstHit, albedo) + sizeof(float)},
    {FirstHitLayer::Albedo, "B", offsetof(FirstHit, albedo) + 2 * sizeof(float)},
    {FirstHitLayer::Normal, "X", offsetof(FirstHit, normal)},
    {FirstHitLayer::Normal, "Y", offsetof(FirstHit, normal) + sizeof(float)},
    {FirstHitLayer::Normal, "Z", offsetof(FirstHit, normal) + 2 * sizeof(float)},
    {FirstHitLayer::Depth, "Z", offsetof(FirstHit, depth)},
    {FirstHitLayer::Position, "X", offsetof(FirstHit, position)},
    {FirstHitLayer::Position, "Y", offsetof(FirstHit, position) + sizeof(float)},
    {FirstHitLayer::Position, "Z", offsetof(FirstHit, position) + 2 * sizeof(float)},
    {FirstHitLayer::Primitive, "ID", offsetof(FirstHit, primitive)},
    {FirstHitLayer::Uv, "U", offsetof(FirstHit, uv)},
    {FirstHitLayer::Uv, "V", offsetof(FirstHit, uv) + sizeof(float)},
};

std::string nameOf(const LayerChannel& channel) {
    return kFirstHitLayerNames[static_cast<size_t>(channel.layer)] + "." + channel.name;
}

Imf::PixelType typeOf(const LayerChannel& channel) {
    return channel.layer == FirstHitLayer::Primitive ? Imf::UINT : Imf::FLOAT;
}

void insertSlice(Imf::FrameBuffer& buffer, const LayerChannel& channel, FirstHitImage& hits,
                 const Imath::Box2i& window) {
    char* const first = reinterpret_cast<char*>(hits.pixels.data()) + channel.offset;
    buffer.insert(nameOf(channel),
                  Imf::Slice::Make(typeOf(channel), first, window, sizeof(FirstHit),
                                   sizeof(FirstHit) * hits.width));
}

struct ErrorChannel {
    const char* name;
    size_t offset; ///< in a PixelError, bytes
};

constexpr ErrorChannel kErrorChannels[] = {
    {"error.SE", offsetof(PixelError, standardError)},
    {"error.CI95", offsetof(PixelError, interval)},
};

/// Calls use(channel) for the channels of the wanted layers.
template <typename Use>
void forEachChannel(std::span<const FirstHitLayer> wanted, const Use& use) {
    for (const FirstHitLayer layer : wanted)
        for (const LayerChannel& channel : kLayerChannels)
            if (channel.layer == layer)
                use(channel);
}

std::vector<LayerChannel> channelsIn(const Imf::Header& header) {
    std::vector<LayerChannel> present;
    for (const LayerChannel& channel : kLayerChannels)
        if (header.channels().findChannel(nameOf(channel)) != nullptr)
            present.push_back(channel);
    return present;
}

FirstHitImage readLayers(const std::filesystem::path& path) {
    const ImageSize size = checkExr(path);
    Imf::InputFile file(path.c_str());
    const std::vector<LayerChannel> channels = channelsIn(file.header());
    if (channels.empty())
        throw SceneError(path.string(),
                         "the file has no layer of first hits; render it with --aov");
    const Imath::Box2i window = file.header().dataWindow();
    FirstHitImage hits(size.width, size.height);
    Imf::FrameBuffer buffer;
    for (const LayerChannel& channel : channels)
        insertSlice(buffer, channel, hits, window);
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return hits;
}

} // namespace

void insertLayers(Imf::Header& header, const ExrLayers& layers) {
    forEachChannel(layers.wanted, [&](const LayerChannel& channel) {
        header.channels().insert(nameOf(channel), Imf::Channel(typeOf(channel)));
    });
    if (!layers.errors.empty())
        for (const ErrorChannel& channel : kErrorChannels)
            header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
}

void insertLayers(Imf::FrameBuffer& buffer, const Imf::Header& header, const ExrLayers& layers) {
    forEachChannel(layers.wanted, [&](const LayerChannel& channel) {
        // OpenEXR takes pointers to mutable memory even where it only reads.
        insertSlice(buffer, channel, const_cast<FirstHitImage&>(*layers.hits), header.dataWindow());
    });
    if (layers.errors.empty())
        return;
    const Imath::Box2i& window = header.dataWindow();
    char* const first = reinterpret_cast<char*>(const_cast<PixelError*>(layers.errors.data()));
    const size_t width = window.max.x - window.min.x + 1;
    for (const ErrorChannel& channel : kErrorChannels)
        buffer.insert(channel.name,
                      Imf::Slice::Make(Imf::FLOAT, first + channel.offset, window,
                                       sizeof(PixelError), sizeof(PixelError) * width));
}

FirstHitImage readFirstHits(const std::filesystem::path& path) {
    return withExrErrors(path, [&] { return readLayers(path); });
}

} // namespace calotype
