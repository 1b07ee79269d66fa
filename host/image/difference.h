#pragma once

#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

#include "image/image.h"

namespace calotype {

/// The largest |A - B| of any channel of any pixel; if several are equal, the first row by row.
struct LargestDifference {
    double magnitude = 0.0;
    uint32_t x = 0;  ///< from the left
    uint32_t y = 0;  ///< from the top
    int channel = 0; ///< 0 red, 1 green, 2 blue
};

/// The difference of picture A from picture B, over pixels that are finite in both.
struct ImageDifference {
    uint64_t infiniteInA = 0; ///< pixels with an infinite channel
    uint64_t infiniteInB = 0;
    uint64_t leftOut = 0; ///< pixels infinite in A or B; the values below ignore them

    glm::dvec3 meanError{0.0}; ///< mean of A - B by channel
    double rmse = 0.0;         ///< root of the mean of (A - B)^2 over pixels and channels
    double relativeMse = 0.0;  ///< mean of relativeSquaredError over pixels and channels
    double peak = 0.0;         ///< the largest value of B; 0 if none is positive
    LargestDifference largest;

    /// The number of pixels that are infinite in exactly one picture.
    uint64_t infiniteInOne() const { return 2 * leftOut - infiniteInA - infiniteInB; }
    /// 10 log10(peak^2 / rmse^2) in dB: infinite if A equals B, else minus infinity for a peak of
    /// 0.
    double psnr() const;
};

/// Throws SceneError, with the name of one picture, unless both have the same size, no pixel has a
/// NaN, and some pixel is finite in both. `nameA` and `nameB` are the files' names.
void requireComparable(const Image& a, const std::string& nameA, const Image& b,
                       const std::string& nameB);

/// For two pictures that pass requireComparable.
ImageDifference measureDifference(const Image& a, const Image& b);

/// (a - b)^2 / (b^2 + 0.01): the squared error of a channel relative to B; the constant limits
/// the weight of dark pixels.
double relativeSquaredError(double a, double b);

/// Whether no channel is infinite or NaN.
bool isFinite(const glm::vec3& pixel);

} // namespace calotype
