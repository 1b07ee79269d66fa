#include "image/difference_picture.h"

#include <cmath>

#include "base/check.h"
#include "image/difference.h"
#include "image/false_color.h"

namespace calotype {
namespace {

glm::u8vec3 differenceColor(const glm::vec3& a, const glm::vec3& b) {
    if (!isFinite(a) || !isFinite(b))
        return DifferenceScale::kInfinite;
    double sum = 0.0;
    for (int channel = 0; channel < 3; ++channel)
        sum += relativeSquaredError(a[channel], b[channel]);
    const double difference = std::sqrt(sum / 3.0);
    if (difference < DifferenceScale::kLeast)
        return DifferenceScale::kBelow;
    return falseColor(std::log(difference / DifferenceScale::kLeast) /
                      std::log(DifferenceScale::kMost / DifferenceScale::kLeast));
}

} // namespace

Rgb8Image differencePicture(const Image& a, const Image& b) {
    CALOTYPE_CHECK_EQ(a.width, b.width);
    CALOTYPE_CHECK_EQ(a.height, b.height);
    Rgb8Image picture(a.width, a.height);
    for (size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = differenceColor(a.pixels[i], b.pixels[i]);
    return picture;
}

} // namespace calotype
