#pragma once

#include "image/features.h"
#include "image/image.h"

namespace calotype {

/// What the camera sees in each pixel, without the noise of light. Both have the picture's size;
/// they are black where nothing is seen.
struct DenoiserFeatures {
    Image albedo; ///< in [0, 1]
    Image normal; ///< in world space, towards the camera; of length 0 to 1
    /// Whether they are means over each pixel. If not, they are of one ray, and their edges are not
    /// those of the picture.
    bool areMeans = true;
};

/// The part of the features that denoisers use.
DenoiserFeatures denoiserFeatures(const FeatureImage& features);

/// Whether `a` comes before `b` in an order of all features: where several devices found them, with
/// other roundings, the first of them is the same whoever is asked first.
bool isBefore(const DenoiserFeatures& a, const DenoiserFeatures& b);

} // namespace calotype
