// From a film to a picture with layers.
#include "film/develop.h"

#include <gtest/gtest.h>

#include "film/error_estimate.h"
#include "shared/limits.h"

namespace calotype {
namespace {

Image grey(float value) {
    Image image(2, 1);
    image.pixels = {glm::vec3(value), glm::vec3(value)};
    return image;
}

/// One channel for each of a layer's, of numbers of their own.
std::vector<Channel> numbered(const Layer& layer) {
    std::vector<Channel> channels;
    for (const std::string& name : layer.channels)
        channels.push_back({name, std::vector<float>(2, static_cast<float>(channels.size() + 1))});
    return channels;
}

std::vector<std::string> namesOfChannels(const Picture& picture) {
    std::vector<std::string> names;
    for (const Channel& channel : picture.channels)
        names.push_back(channel.name);
    return names;
}

TEST(DevelopTest, MakesTheLayersThatAreWanted) {
    const Picture picture = develop(grey(3.0f), {findLayer("depth"), findLayer("uv")}, numbered);
    EXPECT_EQ(picture.color.pixels, grey(3.0f).pixels);
    EXPECT_EQ(namesOfChannels(picture), (std::vector<std::string>{"depth.Z", "uv.U", "uv.V"}));
}

Film twoReplicas() {
    Film film(2, 1, 1.0);
    constexpr float kWhole = shared::kSamplesPerBlock;
    for (uint32_t block = 0; block < 2; ++block) {
        const float light = 16.0f * static_cast<float>(block + 1);
        const std::vector<glm::vec4> sums(2, {light, light, light, kWhole});
        film.addBlock(block, sums);
    }
    return film;
}

TEST(DevelopTest, TakesErrorsFromTheFilm) {
    const Film film = twoReplicas();
    const std::vector<Channel> channels = channelsOf(*findLayer("error"), film);
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(std::get<std::vector<float>>(channels[1].pixels)[1], pixelErrors(film)[1].interval);
}

} // namespace
} // namespace calotype
