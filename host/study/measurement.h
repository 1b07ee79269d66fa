#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.h"
#include "study/variant.h"

namespace calotype {

/// A variant's picture at one moment.
struct CurvePoint {
    double samples = 0.0; ///< mean of all pixels
    double seconds = 0.0; ///< of sampling, at the machine's usual pace
    /// The picture's distance from the reference as ErrorEstimate::relative measures it, less the
    /// reference's own error. None where the reference is not good enough to tell.
    std::optional<double> error;
    std::optional<double> stated; ///< what the variant says of itself
    Image part;                   ///< the middle of the picture
};

/// What became of a variant.
struct Measurement {
    Variant variant;
    std::vector<CurvePoint> curve; ///< at 1, 2, 4, ... samples, and at the end
    double pace = 1.0;             ///< the machine's meanwhile, over its usual one
    double buildSeconds = 0.0;     ///< of the BVH, and packing
    double compileSeconds = 0.0;
    /// Mean luminance over that of the reference, less 1, and its standard error.
    double brighter = 0.0;
    double brighterError = 0.0;
    bool isTrusted = false; ///< ErrorEstimate::isTrusted

    const CurvePoint& last() const { return curve.back(); }

    /// The error that stays however long it runs: 0 unless it loses light by design; none where it
    /// does, and how much is not known: of too few samples, or ones that are not to be trusted.
    std::optional<double> floor() const;

    /// Sampling until the error is `target`: between the points of the curve, and beyond them as
    /// the root of time has it, about the floor. None where it never gets there, or nothing is
    /// known.
    std::optional<double> secondsTo(double target) const;
};

/// Of all measurements' points, those that none beats in both time and error; by time.
std::vector<CurvePoint> paretoFront(const std::vector<Measurement>& measurements);

} // namespace calotype
