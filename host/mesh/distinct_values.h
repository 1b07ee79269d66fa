#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace calotype {

/// Numbers distinct vectors of doubles (glm::dvec2, glm::dvec3) from 0 in the order of their first
/// appearance; fewer than 2^32. 0 and -0 are equal. A flat hash table, for meshes of millions of
/// positions.
template <typename Vector>
class DistinctValues {
public:
    /// Makes room for `count` values in all, so that adding them moves nothing.
    void reserve(size_t count) {
        values_.reserve(count);
        if (2 * count >= slots_.size())
            resize(std::bit_ceil(2 * count + 1));
    }

    /// The number of `value`; adds it if it is new.
    uint32_t add(const Vector& value) {
        if (2 * values_.size() >= slots_.size())
            resize(std::max(kFewestSlots, 2 * slots_.size()));
        uint32_t& slot = slotOf(value);
        if (slot == kEmpty) {
            slot = static_cast<uint32_t>(values_.size());
            values_.push_back(value);
        }
        return slot;
    }

    /// Adds all `values` and returns their numbers.
    std::vector<uint32_t> addAll(std::span<const Vector> values) {
        reserve(values_.size() + values.size());
        std::vector<uint32_t> numbers;
        numbers.reserve(values.size());
        for (const Vector& value : values)
            numbers.push_back(add(value));
        return numbers;
    }

    const Vector& operator[](uint32_t number) const { return values_[number]; }
    std::span<const Vector> values() const { return values_; }
    std::vector<Vector> take() && { return std::move(values_); }

private:
    static constexpr uint32_t kEmpty = ~0u;
    static constexpr size_t kFewestSlots = 16;

    static uint64_t hash(const Vector& value) {
        uint64_t hash = 0;
        for (int i = 0; i < Vector::length(); ++i) {
            // Adding zero gives -0 and 0, which are equal, the same bits.
            const auto bits = std::bit_cast<uint64_t>(value[i] + 0.0);
            hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 32;
        }
        return hash;
    }

    /// The slot where `value` is or belongs. The number of slots is a power of two; at most half of
    /// them are used.
    uint32_t& slotOf(const Vector& value) {
        const size_t mask = slots_.size() - 1;
        size_t i = hash(value) & mask;
        while (slots_[i] != kEmpty && values_[slots_[i]] != value)
            i = (i + 1) & mask;
        return slots_[i];
    }

    /// `slots` is a power of two.
    void resize(size_t slots) {
        slots_.assign(slots, kEmpty);
        for (size_t i = 0; i < values_.size(); ++i)
            slotOf(values_[i]) = static_cast<uint32_t>(i);
    }

    std::vector<Vector> values_;
    std::vector<uint32_t> slots_; ///< numbers, or kEmpty
};

} // namespace calotype
