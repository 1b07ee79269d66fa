// From a film to a picture with layers.
#include "film/develop.h"

#include <algorithm>

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

/// Divides the colour by the green albedo, and keeps what was there before.
void demodulate(Picture& picture) {
    const auto albedo = std::ranges::find(picture.channels, "albedo.G", &Channel::name);
    ASSERT_NE(albedo, picture.channels.end());
    std::vector<float> before;
    for (size_t i = 0; i < picture.color.pixels.size(); ++i) {
        before.push_back(picture.color.pixels[i].g);
        picture.color.pixels[i] /= std::get<std::vector<float>>(albedo->pixels)[i];
    }
    picture.channels.push_back({"before.G", before});
    picture.metadata.push_back({"stage", "demodulate"});
}

void addOne(Picture& picture) {
    for (glm::vec3& pixel : picture.color.pixels)
        pixel += 1.0f;
}

const Stage kDemodulate{"demodulate", "", {"albedo", "depth"}, demodulate};
const Stage kAddOne{"add-one", "", {}, addOne};

TEST(DevelopTest, MakesTheLayersThatAreWanted) {
    const Picture picture =
        develop(grey(3.0f), {findLayer("depth"), findLayer("uv")}, {}, numbered);
    EXPECT_EQ(picture.color.pixels, grey(3.0f).pixels);
    EXPECT_EQ(namesOfChannels(picture), (std::vector<std::string>{"depth.Z", "uv.U", "uv.V"}));
}

TEST(DevelopTest, RunsTheStagesInTheirOrder) {
    EXPECT_EQ(develop(grey(3.0f), {}, {&kAddOne, &kDemodulate}, numbered).color.pixels,
              grey(2.0f).pixels);
    EXPECT_EQ(develop(grey(3.0f), {}, {&kDemodulate, &kAddOne}, numbered).color.pixels,
              grey(2.5f).pixels);
}

TEST(DevelopTest, GivesStagesTheirLayersAndKeepsWhatTheyAdd) {
    const LayerList wanted = {findLayer("depth")};
    EXPECT_EQ(namesOf(neededLayers(wanted, {&kDemodulate, &kAddOne})), "depth, albedo");
    const Picture picture = develop(grey(3.0f), wanted, {&kDemodulate}, numbered);
    EXPECT_EQ(namesOfChannels(picture), (std::vector<std::string>{"depth.Z", "before.G"}));
    ASSERT_EQ(picture.metadata.size(), 1u);
    EXPECT_EQ(picture.metadata[0].name, "stage");
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
