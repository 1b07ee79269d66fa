#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

namespace calotype {

/// A 64-bit hash of a sequence of texts, eight bytes at a time, mixed by the finaliser of
/// splitmix64. Detects different contents; not cryptographic.
class ContentHash {
public:
    /// Boundaries of texts count: "ab", "c" differs from "a", "bc".
    void add(std::string_view text) {
        addWord(text.size());
        while (!text.empty()) {
            uint64_t word = 0;
            const size_t count = text.size() < sizeof word ? text.size() : sizeof word;
            std::memcpy(&word, text.data(), count);
            addWord(word);
            text.remove_prefix(count);
        }
    }

    uint64_t value() const { return state_; }

private:
    void addWord(uint64_t word) {
        uint64_t z = (state_ ^ word) + 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        state_ = z ^ (z >> 31);
    }

    uint64_t state_ = 0;
};

} // namespace calotype
