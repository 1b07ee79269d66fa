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

/// The bits that differ from the number's sign.
Bits magnitudeOf(FixedPoint number) {
    return static_cast<Bits>(number ^ (number >> (kNumberBits - 1)));
}

} // namespace

FixedPointArray::FixedPointArray(size_t size)
    : size_(size), chunks_((size + kChunkNumbers - 1) / kChunkNumbers) {}

size_t FixedPointArray::numbersIn(size_t chunk) const {
    return std::min(kChunkNumbers, size_ - chunk * kChunkNumbers);
}

FixedPointArray::Extent::Extent(std::span<const FixedPoint> numbers) {
    Bits any = 0;
    Bits magnitude = 0;
    for (const FixedPoint number : numbers) {
        any |= static_cast<Bits>(number);
        magnitude |= magnitudeOf(number);
    }
    isZero = any == 0;
    firstByte = isZero ? 0 : trailingZeros(any) / kBitsPerByte;
    bits = bitWidth(magnitude);
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
/// anew, and has a bit to spare, so that addInPlace can be used next time.
void FixedPointArray::store(size_t index, std::span<const FixedPoint> numbers) {
    Chunk& chunk = chunks_[index];
    const Extent extent(numbers);
    if (extent.isZero) {
        chunk = {};
        return;
    }
    const bool isNew = chunk.range.width == 0;
    const int oldEnd = chunk.range.first + chunk.range.width;
    const int bitsOfSum = std::min(extent.bits + 1, kNumberBits - 1);
    const int neededEnd = bitsOfSum / kBitsPerByte + 1; // with at least one bit of the sign
    const int first = isNew ? extent.firstByte : std::min<int>(chunk.range.first, extent.firstByte);
    const int end = isNew ? neededEnd : std::max(oldEnd, neededEnd);
    chunk.range = {static_cast<uint8_t>(first), static_cast<uint8_t>(end - first)};
    chunk.usedBits = static_cast<uint8_t>(extent.bits);
    const size_t bytes = numbers.size() * chunk.range.width + kPadding;
    if (chunk.bytes.size() != bytes) {
        chunk.bytes = {}; // before the new allocation, which may then take its place
        chunk.bytes = std::vector<uint8_t>(bytes);
    }
    uint8_t* target = chunk.bytes.data();
    for (const FixedPoint number : numbers) {
        const FixedPoint shifted = number >> kBitsPerByte * first;
        std::memcpy(target, &shifted,
                    sizeof shifted); // the next number overwrites what is too much
        target += chunk.range.width;
    }
}

/// Whether the chunk's bytes hold every sum of one of its numbers and one of the terms.
bool FixedPointArray::holdsSum(const Chunk& chunk, const Extent& terms) {
    const int bitsOfSum = std::max<int>(chunk.usedBits, terms.bits) + 1;
    return chunk.range.width > 0 && terms.firstByte >= chunk.range.first &&
           bitsOfSum < kBitsPerByte * (chunk.range.first + chunk.range.width);
}

/// Adds terms that the chunk's bytes hold. All sums are computed before the first is stored: a
/// processor waits where it loads bytes of two numbers that it has just stored.
void FixedPointArray::addInPlace(Chunk& chunk, size_t first, std::span<const FixedPoint> terms) {
    const size_t width = chunk.range.width;
    const int shift = kBitsPerByte * chunk.range.first;
    const int unused = kNumberBits - kBitsPerByte * static_cast<int>(width);
    uint8_t* const place = chunk.bytes.data() + first * width;
    ChunkBuffer sums;
    Bits magnitude = 0;
    for (size_t i = 0; i < terms.size(); ++i) {
        Bits word = 0;
        std::memcpy(&word, place + i * width, sizeof word);
        sums[i] = (static_cast<FixedPoint>(word << unused) >> unused) + (terms[i] >> shift);
        magnitude |= magnitudeOf(sums[i]);
    }
    // Each number overwrites what the one before it stored too much; the last one must not.
    uint8_t* const end = place + terms.size() * width;
    std::array<uint8_t, kPadding> behind;
    std::memcpy(behind.data(), end, kPadding);
    for (size_t i = 0; i < terms.size(); ++i)
        std::memcpy(place + i * width, &sums[i], sizeof(FixedPoint));
    std::memcpy(end, behind.data(), kPadding);
    chunk.usedBits = std::max(chunk.usedBits, static_cast<uint8_t>(bitWidth(magnitude) + shift));
}

void FixedPointArray::read(size_t first, std::span<FixedPoint> numbers) const {
    CALOTYPE_CHECK_LE(first + numbers.size(), size_);
    for (size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = (*this)[first + i];
}

template <typename Use>
void FixedPointArray::forEachChunk(size_t first, std::span<const FixedPoint> operands,
                                   const Use& use) {
    CALOTYPE_CHECK_LE(first + operands.size(), size_);
    while (!operands.empty()) {
        const size_t chunk = first / kChunkNumbers;
        const size_t offset = first % kChunkNumbers;
        const size_t count = std::min(operands.size(), kChunkNumbers - offset);
        use(chunk, offset, operands.first(count));
        first += count;
        operands = operands.subspan(count);
    }
}

template <typename Change>
void FixedPointArray::change(size_t chunk, size_t first, std::span<const FixedPoint> operands,
                             const Change& change) {
    ChunkBuffer buffer;
    const std::span<FixedPoint> numbers = std::span(buffer).first(numbersIn(chunk));
    for (size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = numberOf(chunks_[chunk], i);
    for (size_t i = 0; i < operands.size(); ++i)
        change(numbers[first + i], operands[i]);
    store(chunk, numbers);
}

void FixedPointArray::write(size_t first, std::span<const FixedPoint> numbers) {
    forEachChunk(first, numbers, [&](size_t chunk, size_t offset, auto values) {
        change(chunk, offset, values, [](FixedPoint& number, FixedPoint value) { number = value; });
    });
}

void FixedPointArray::add(size_t first, std::span<const FixedPoint> terms) {
    forEachChunk(first, terms, [&](size_t chunk, size_t offset, auto part) {
        const Extent extent(part);
        if (extent.isZero)
            return;
        if (holdsSum(chunks_[chunk], extent))
            addInPlace(chunks_[chunk], offset, part);
        else
            change(chunk, offset, part,
                   [](FixedPoint& number, FixedPoint term) { number += term; });
    });
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
