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
    /// Of sampling, and of a denoised picture of denoising, at the machine's usual pace.
    double seconds = 0.0;
    /// The picture's distance from the ground truth as ErrorEstimate::relative measures it, less
    /// the ground truth's own error. None where the ground truth is not accurate enough.
    std::optional<double> error;
    std::optional<double> stated; ///< the estimate that the variant itself computes
    Image part;                   ///< the middle of the picture
    /// Of a denoised picture, if it has a stated error: DenoisedError::bound.
    std::optional<double> bound = {};
};

/// The middle of a picture, at most 256 pixels on a side, not scaled. The page shows this part.
Image middleOf(const Image& image);

/// The measured curve of a variant.
struct Measurement {
    Variant variant;
    /// At 1, 2, 4, ... samples, and at the end; of a denoised variant from 128 samples on.
    std::vector<CurvePoint> curve;
    double pace = 1.0; ///< of the machine during the measurement, relative to its usual pace
    double buildSeconds = 0.0; ///< of the BVH, and packing
    double compileSeconds = 0.0;
    /// Mean luminance over that of the ground truth, less 1, and its standard error.
    double brighter = 0.0;
    double brighterError = 0.0;
    bool isTrusted = false; ///< ErrorEstimate::isTrusted

    const CurvePoint& last() const { return curve.back(); }

    /// The error that remains however long it runs: 0 unless the variant loses light by design.
    /// None if it does, but how much is unknown: too few samples, or an error that is not trusted.
    std::optional<double> floor() const;

    /// CurvePoint::seconds until the error is `target`: interpolated between the points of the
    /// curve; beyond them, the part of the error above the floor falls with the square root of the
    /// time. None if the error is never reached, or nothing is known: of a denoised variant, whose
    /// error falls more slowly, nothing is known beyond the points.
    std::optional<double> secondsTo(double target) const;

    /// Whether the curve itself reaches this error, so that secondsTo is not extrapolated.
    bool reaches(double target) const;
};

/// A time, above 0, and an error that is reached then.
struct FrontPoint {
    double seconds = 0.0;
    double error = 0.0;
};

/// The points of the curve whose errors are known.
std::vector<FrontPoint> knownPoints(const Measurement& measurement);

/// The lower envelope of all curves, by time: at each time that was measured and at a few between,
/// the smallest error so far, interpolated along the curves. Errors never grow along it.
std::vector<FrontPoint> paretoFront(const std::vector<Measurement>& measurements);

} // namespace calotype
