#include "image/cryptomatte.h"

#include <bit>

#include <nlohmann/json.hpp>

#include "image/byte_order.h"

namespace calotype {
namespace {

constexpr uint32_t kFactor1 = 0xcc9e2d51u;
constexpr uint32_t kFactor2 = 0x1b873593u;

uint32_t scrambled(uint32_t word) { return std::rotl(word * kFactor1, 15) * kFactor2; }

std::string hexadecimalOf(float id) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto bits = std::bit_cast<uint32_t>(id);
    std::string text;
    for (int shift = 28; shift >= 0; shift -= 4)
        text += kDigits[bits >> shift & 15u];
    return text;
}

} // namespace

uint32_t murmurHash3(std::string_view bytes, uint32_t seed) {
    uint32_t hash = seed;
    const auto length = static_cast<uint32_t>(bytes.size());
    for (; bytes.size() >= 4; bytes.remove_prefix(4)) {
        hash ^= scrambled(littleEndian32(bytes, 0));
        hash = std::rotl(hash, 13) * 5 + 0xe6546b64u;
    }
    uint32_t rest = 0;
    for (size_t i = 0; i < bytes.size(); ++i)
        rest |= uint32_t{static_cast<unsigned char>(bytes[i])} << 8 * i;
    hash ^= scrambled(rest); // 0 stays 0
    hash ^= length;
    hash = (hash ^ hash >> 16) * 0x85ebca6bu;
    hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
    return hash ^ hash >> 16;
}

float cryptomatteId(std::string_view name) {
    uint32_t hash = murmurHash3(name);
    const uint32_t exponent = hash >> 23 & 255u;
    if (exponent == 0 || exponent == 255) // zero, denormal; infinite, NaN
        hash ^= 1u << 23;
    return std::bit_cast<float>(hash);
}

std::vector<std::string> cryptomatteChannels(const std::string& typeName) {
    static_assert(kCryptomatteRanks % 2 == 0 && kCryptomatteRanks < 20);
    std::vector<std::string> channels;
    for (uint32_t group = 0; group < kCryptomatteRanks / 2; ++group)
        for (const char* component : {"R", "G", "B", "A"})
            channels.push_back(typeName + "0" + std::to_string(group) + "." + component);
    return channels;
}

std::vector<Attribute> cryptomatteAttributes(const std::string& typeName,
                                             std::span<const std::string> names) {
    nlohmann::ordered_json manifest = nlohmann::ordered_json::object();
    for (const std::string& name : names)
        manifest[name] = hexadecimalOf(cryptomatteId(name));
    const std::string prefix =
        std::string(kCryptomattePrefix) + hexadecimalOf(cryptomatteId(typeName)).substr(0, 7) + "/";
    return {{prefix + "name", typeName},
            {prefix + "hash", "MurmurHash3_32"},
            {prefix + "conversion", "uint32_to_float32"},
            {prefix + "manifest", manifest.dump()}};
}

} // namespace calotype
