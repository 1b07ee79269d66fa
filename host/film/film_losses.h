#pragma once

#include <cstdint>

namespace calotype {

/// Samples of a film that are missing or wrong.
struct FilmLosses {
    uint64_t nonFiniteSamples = 0; ///< samples that count as black
    uint64_t cutPaths = 0;         ///< ended by the loop budget of one dispatch: too dark
    uint64_t nonFinitePixels = 0;  ///< of blocks: not finite, counted as black
    uint64_t overflowedPixels = 0; ///< of blocks: too bright, counted as black

    uint64_t lostPixels() const { return nonFinitePixels + overflowedPixels; }
    FilmLosses& operator+=(const FilmLosses& other);
    bool operator==(const FilmLosses&) const = default;
};

} // namespace calotype
