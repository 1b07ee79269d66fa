#include "film/fixed_point_array.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "base/check.h"

namespace calotype {
namespace {

using Bits = unsigned __int128;
using ChunkBuffer = std::array<FixedPoint, FixedPointArray::kChunkNumbers>;

constexpr int kBitsPerByte = 8;
constexpr int kNumberBits = 128;

static_assert(std::endian::native == std::endian::little, "numbers are stored low byte first");

int bitWidth(Bits bits) {
    const auto high = static_cast<uint64_t>(bits >> 64);
    const auto low = static_cast<uint64_t>(bits);
    return static_cast<int>(high != 0 ? 64 + std::bit_width(high) : std::bit_width(low));
}

int trailingZeros(Bits bits) {
    const auto high = static_cast<uint64_t>(bits >> 64);
    const auto low = static_cast<uint64_t>(bits);
    return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(high);
}

} // namespace

FixedPointArray::FixedPointArray(size_t size)
    : size_(size), chunks_((size + kChunkNumbers - 1) / kChunkNumbers) {}

size_t FixedPointArray::numbersIn(size_t chunk) const {
    return std::min(kChunkNumbers, size_ - chunk * kChunkNumbers);
}

/// The fewest bytes that hold the numbers; of width 0 where all of them are 0.
FixedPointArray::ByteRange FixedPointArray::rangeOf(std::span<const FixedPoint> numbers) {
    Bits any = 0;       // bits that are set in one of the numbers
    Bits magnitude = 0; // bits that differ from the sign in one of the numbers
    for (const FixedPoint number : numbers) {
        any |= static_cast<Bits>(number);
        magnitude |= static_cast<Bits>(number ^ (number >> (kNumberBits - 1)));
    }
    if (any == 0)
        return {};
    const int first = trailingZeros(any) / kBitsPerByte;
    const int end = bitWidth(magnitude) / kBitsPerByte + 1; // with at least one bit of the sign
    return {static_cast<uint8_t>(first), static_cast<uint8_t>(end - first)};
}

FixedPoint FixedPointArray::numberOf(const Chunk& chunk, size_t index) {
    const ByteRange range = chunk.range;
    if (range.width == 0)
        return 0;
    Bits bits = 0;
    std::memcpy(&bits, chunk.bytes.data() + index * range.width, sizeof bits);
    // The bytes of the next number are shifted out, and the sign is repeated above this one's.
    const int unused = kNumberBits - kBitsPerByte * range.width;
    const FixedPoint number = static_cast<FixedPoint>(bits << unused) >> unused;
    return static_cast<FixedPoint>(static_cast<Bits>(number) << kBitsPerByte * range.first);
}

FixedPoint FixedPointArray::operator[](size_t index) const {
    return numberOf(chunks_[index / kChunkNumbers], index % kChunkNumbers);
}

/// Sets all numbers of a chunk. The range of bytes only grows, so that a chunk is seldom allocated
/// anew.
void FixedPointArray::store(size_t index, std::span<const FixedPoint> numbers) {
    Chunk& chunk = chunks_[index];
    const ByteRange needed = rangeOf(numbers);
    if (needed.width == 0) {
        chunk = {};
        return;
    }
    const int oldEnd = chunk.range.first + chunk.range.width;
    const int neededEnd = needed.first + needed.width;
    if (chunk.range.width == 0) {
        chunk.range = needed;
    } else if (needed.first < chunk.range.first || neededEnd > oldEnd) {
        chunk.range.first = std::min(chunk.range.first, needed.first);
        chunk.range.width = static_cast<uint8_t>(std::max(oldEnd, neededEnd) - chunk.range.first);
    }
    const size_t bytes = numbers.size() * chunk.range.width + kPadding;
    if (chunk.bytes.size() != bytes) {
        chunk.bytes = {}; // before the new allocation, which may then take its place
        chunk.bytes = std::vector<uint8_t>(bytes);
    }
    uint8_t* target = chunk.bytes.data();
    for (const FixedPoint number : numbers) {
        const FixedPoint shifted = number >> kBitsPerByte * chunk.range.first;
        std::memcpy(target, &shifted,
                    sizeof shifted); // the next number overwrites what is too much
        target += chunk.range.width;
    }
}

void FixedPointArray::read(size_t first, std::span<FixedPoint> numbers) const {
    CALOTYPE_CHECK_LE(first + numbers.size(), size_);
    for (size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = (*this)[first + i];
}

template <typename Change>
void FixedPointArray::update(size_t first, std::span<const FixedPoint> operands,
                             const Change& change) {
    CALOTYPE_CHECK_LE(first + operands.size(), size_);
    while (!operands.empty()) {
        const size_t chunk = first / kChunkNumbers;
        const size_t offset = first % kChunkNumbers;
        ChunkBuffer buffer;
        const std::span<FixedPoint> numbers = std::span(buffer).first(numbersIn(chunk));
        const size_t count = std::min(operands.size(), numbers.size() - offset);
        for (size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = numberOf(chunks_[chunk], i);
        for (size_t i = 0; i < count; ++i)
            change(numbers[offset + i], operands[i]);
        store(chunk, numbers);
        first += count;
        operands = operands.subspan(count);
    }
}

void FixedPointArray::write(size_t first, std::span<const FixedPoint> numbers) {
    update(first, numbers, [](FixedPoint& number, FixedPoint value) { number = value; });
}

void FixedPointArray::add(size_t first, std::span<const FixedPoint> terms) {
    update(first, terms, [](FixedPoint& number, FixedPoint term) { number += term; });
}

void FixedPointArray::add(const FixedPointArray& other) {
    CALOTYPE_CHECK_EQ(size_, other.size_);
    ChunkBuffer buffer;
    for (size_t chunk = 0; chunk < chunks_.size(); ++chunk) {
        const std::span<FixedPoint> terms = std::span(buffer).first(numbersIn(chunk));
        other.read(chunk * kChunkNumbers, terms);
        add(chunk * kChunkNumbers, terms);
    }
}

size_t FixedPointArray::memoryBytes() const {
    size_t bytes = chunks_.size() * sizeof(Chunk);
    for (const Chunk& chunk : chunks_)
        bytes += chunk.bytes.size();
    return bytes;
}

bool FixedPointArray::operator==(const FixedPointArray& other) const {
    if (size_ != other.size_)
        return false;
    for (size_t i = 0; i < size_; ++i)
        if ((*this)[i] != other[i])
            return false;
    return true;
}

} // namespace calotype
