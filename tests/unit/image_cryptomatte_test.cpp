// Mattes: hashes against published ones, ranks, and attributes.
#include "image/cryptomatte.h"

#include <bit>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "image/exr.h"
#include "image/first_hit.h"
#include "image/layers.h"
#include "support/scratch_folder.h"

namespace calotype::test {
namespace {

// Appleby's own check of MurmurHash3_x86_32 (SMHasher, KeysetTest.cpp): the hash of the hashes of
// the keys {}, {0}, {0, 1}, ... of up to 255 bytes, with the seeds 256, 255, ...
TEST(MurmurHash3Test, HasTheVerificationValue) {
    std::string key;
    std::string hashes;
    for (uint32_t i = 0; i < 256; ++i) {
        const uint32_t hash = murmurHash3(key, 256 - i);
        for (uint32_t byte = 0; byte < 4; ++byte)
            hashes += static_cast<char>(hash >> 8 * byte);
        key += static_cast<char>(i);
    }
    EXPECT_EQ(murmurHash3(hashes, 0), 0xB0F57EE3u);
}

// From the manifest of the sample image bunny_CryptoObject, which is published with the
// specification.
TEST(CryptomatteTest, IdsAreThoseOfThePublishedManifest) {
    const std::map<std::string, uint32_t> manifest = {
        {"bunny", 0x13851a76},
        {"bush", 0xf763d090},
        {"flowerA.flowerA_petal1.:134", 0xdbc045b9},
        {"flowerA.flowerA_petal1.:1118", 0xfb9b7918},
        // Its hash has the exponent 255.
        {"flowerA.flowerA_petal1.:1065", 0x7f0e5296},
    };
    for (const auto& [name, bits] : manifest)
        EXPECT_EQ(std::bit_cast<uint32_t>(cryptomatteId(name)), bits) << name;
    EXPECT_EQ(std::bit_cast<uint32_t>(cryptomatteId("default")), 0x42c9679fu) << "specification";
    EXPECT_EQ(murmurHash3("flowerA.flowerA_petal1.:1065"), 0x7f8e5296u);
    // By the Python package mmh3: a hash of the exponent 0, which becomes 1.
    EXPECT_EQ(murmurHash3("object 259"), 0x0069b367u);
    EXPECT_EQ(std::bit_cast<uint32_t>(cryptomatteId("object 259")), 0x00e9b367u);
}

TEST(CryptomatteTest, IdsAreNormalNumbers) {
    for (uint32_t i = 0; i < 100'000; ++i)
        ASSERT_TRUE(std::isnormal(cryptomatteId(std::to_string(i)))) << i;
}

TEST(CryptomatteTest, AttributesHaveTheManifest) {
    const std::vector<std::string> names = {"bunny", "a \"quoted\" name", "B\xc3\xa4r"};
    const auto attributes = cryptomatteAttributes("CryptoObject", names);
    std::map<std::string, std::string> texts;
    for (const Attribute& attribute : attributes)
        texts[attribute.name] = std::get<std::string>(attribute.value);
    ASSERT_EQ(texts.size(), 4u);
    // 7 digits of the id of "CryptoObject", by the Python package mmh3.
    const std::string prefix = "cryptomatte/3ae39a5/";
    EXPECT_EQ(texts[prefix + "name"], "CryptoObject");
    EXPECT_EQ(texts[prefix + "hash"], "MurmurHash3_32");
    EXPECT_EQ(texts[prefix + "conversion"], "uint32_to_float32");
    const auto manifest = nlohmann::json::parse(texts[prefix + "manifest"]);
    EXPECT_EQ(manifest.size(), 3u);
    EXPECT_EQ(manifest["bunny"], "13851a76");
    EXPECT_EQ(manifest["B\xc3\xa4r"], "2e620738"); // UTF-8, likewise
    ScratchFolder folder;
    writeExr(folder / "a.exr", Picture{Image(2, 1), {}, attributes});
    const std::vector<Attribute> read = readExrMetadata(folder / "a.exr");
    ASSERT_EQ(read.size(), 4u);
    for (const Attribute& attribute : read)
        EXPECT_EQ(std::get<std::string>(attribute.value), texts.at(attribute.name));
}

TEST(CoverageTest, RanksTheLargestShareFirst) {
    constexpr uint32_t kNone = kNoPrimitive;
    Coverage coverage(3);
    const std::vector<uint32_t> thingOf = {5, 5, 2, 9}; // of primitives 0 to 3
    const std::vector<std::vector<uint32_t>> rays = {
        {2, kNone, 3}, {0, kNone, 2}, {1, kNone, kNone}, {1, kNone, 0}};
    for (const auto& ray : rays)
        coverage.addRay(ray, thingOf);
    const auto textOf = [&](size_t pixel) {
        std::string text;
        for (const auto& [thing, share] : coverage.ranked(pixel))
            text += std::to_string(thing) + ":" + std::to_string(int(100 * share)) + " ";
        return text;
    };
    EXPECT_EQ(textOf(0), "5:75 2:25 ");
    EXPECT_EQ(textOf(1), "");
    EXPECT_EQ(textOf(2), "2:25 5:25 9:25 ") << "equal ones by their number";
}

// Of eight things in a pixel, the layer has the six that cover most.
TEST(CoverageTest, ALayerHasSixRanks) {
    Coverage coverage(2);
    const std::vector<uint32_t> thingOf = {0, 1, 2, 3, 4, 5, 6, 7};
    for (uint32_t thing = 0; thing < 8; ++thing)
        for (uint32_t ray = 0; ray <= thing; ++ray)
            coverage.addRay(std::vector<uint32_t>{thing, kNoPrimitive}, thingOf);
    const std::vector<float> ids = {10, 11, 12, 13, 14, 15, 16, 17};
    const auto channels = channelsOf(*findLayer("cryptoObject"), coverage, ids);
    ASSERT_EQ(channels.size(), 12u);
    for (uint32_t rank = 0; rank < 6; ++rank) {
        const auto& id = std::get<std::vector<float>>(channels[2 * rank].pixels);
        const auto& share = std::get<std::vector<float>>(channels[2 * rank + 1].pixels);
        EXPECT_EQ(id, (std::vector<float>{17.0f - static_cast<float>(rank), 0.0f}));
        EXPECT_EQ(share[0], static_cast<float>(8 - rank) / 36.0f);
        EXPECT_EQ(share[1], 0.0f);
    }
}

} // namespace
} // namespace calotype::test
