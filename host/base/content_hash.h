#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace calotype {

/// A 64-bit hash of a sequence of texts, eight bytes at a time, mixed by the finaliser of
/// splitmix64. Detects different contents; not cryptographic.
class ContentHash {
public:
    /// Boundaries of texts count: "ab", "c" differs from "a", "bc".
    void add(std::string_view text) { add(std::span(&text, 1)); }

    /// Adds the text that the pieces make together, without joining them.
    void add(std::span<const std::string_view> pieces) {
        uint64_t size = 0;
        for (const std::string_view piece : pieces)
            size += piece.size();
        addWord(size);
        uint64_t word = 0;
        size_t filled = 0; // bytes of the word
        for (std::string_view piece : pieces)
            while (!piece.empty()) {
                const size_t count = std::min(piece.size(), sizeof word - filled);
                std::memcpy(reinterpret_cast<char*>(&word) + filled, piece.data(), count);
                piece.remove_prefix(count);
                filled += count;
                if (filled == sizeof word) {
                    addWord(word);
                    word = 0;
                    filled = 0;
                }
            }
        if (filled > 0)
            addWord(word);
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
