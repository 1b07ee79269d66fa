#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "film/fixed_point.h"

namespace calotype {

/// An array of fixed-point numbers, exact, in as few bytes as they need. It is stored in chunks of
/// kChunkNumbers. The numbers of a chunk share one range of bytes: a zero byte below it, or a byte
/// that only repeats the sign above it, is not stored. A chunk of zeros takes no bytes; the sums of
/// a picture take 6 to 10 bytes a number instead of 16.
///
/// Functions that change numbers may run at the same time where their numbers are in different
/// chunks.
class FixedPointArray {
public:
    static constexpr size_t kChunkNumbers = 1024;

    /// Zeros.
    explicit FixedPointArray(size_t size = 0);

    size_t size() const { return size_; }
    FixedPoint operator[](size_t index) const;

    /// Copies the numbers from `first` on to `numbers`.
    void read(size_t first, std::span<FixedPoint> numbers) const;

    /// Replaces the numbers from `first` on.
    void write(size_t first, std::span<const FixedPoint> numbers);

    /// Adds terms to the numbers from `first` on.
    void add(size_t first, std::span<const FixedPoint> terms);

    /// Adds an array of the same size.
    void add(const FixedPointArray& other);

    /// Bytes of memory that the numbers take.
    size_t memoryBytes() const;

    /// Whether the numbers are equal, however they are stored.
    bool operator==(const FixedPointArray& other) const;

private:
    /// Bytes `first` to `first + width` (exclusive) of each number, in two's complement.
    struct ByteRange {
        uint8_t first = 0;
        uint8_t width = 0;
    };
    struct Chunk {
        ByteRange range;
        uint8_t usedBits = 0; ///< all numbers are in [-2^usedBits, 2^usedBits)
        /// `width` bytes of each number, and kPadding more, so that every number can be copied in
        /// one step of 16 bytes. Empty where all numbers are 0.
        std::vector<uint8_t> bytes;
    };
    static constexpr size_t kPadding = sizeof(FixedPoint);

    /// The bits that are set in one of several numbers, and those that differ from its sign.
    struct Extent {
        explicit Extent(std::span<const FixedPoint> numbers);

        int firstByte = 0; ///< below it all are 0
        int bits = 0;      ///< all numbers are in [-2^bits, 2^bits)
        bool isZero = true;
    };

    static FixedPoint numberOf(const Chunk& chunk, size_t index);
    static bool holdsSum(const Chunk& chunk, const Extent& terms);
    static void addInPlace(Chunk& chunk, size_t first, std::span<const FixedPoint> terms);

    size_t numbersIn(size_t chunk) const;
    void store(size_t chunk, std::span<const FixedPoint> numbers);
    /// Calls change(old, operand) for the numbers of a chunk from `first` on, and stores them.
    template <typename Change>
    void change(size_t chunk, size_t first, std::span<const FixedPoint> operands,
                const Change& change);
    /// Calls use(chunk, first number in it, part of the operands) for the chunks that hold the
    /// numbers from `first` on.
    template <typename Use>
    void forEachChunk(size_t first, std::span<const FixedPoint> operands, const Use& use);

    size_t size_;
    std::vector<Chunk> chunks_;
};

} // namespace calotype
