#include "image/metrics.h"

#include <string>

#include "base/error.h"

namespace calotype {
namespace {

std::string sizeOf(const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

void requirePixels(const Image& image) {
    if (image.pixels.empty())
        throw Error("the picture has no pixels; there is nothing to measure");
}

} // namespace

glm::dvec3 imageMean(const Image& image) {
    requirePixels(image);
    glm::dvec3 sum(0.0);
    for (const glm::vec3& pixel : image.pixels)
        sum += glm::dvec3(pixel);
    return sum / static_cast<double>(image.pixels.size());
}

double relativeSquaredError(double test, double reference) {
    constexpr double kFloor = 0.01;
    const double error = test - reference;
    return error * error / (reference * reference + kFloor);
}

double relativeMse(const Image& test, const Image& reference) {
    if (test.width != reference.width || test.height != reference.height)
        throw Error("pictures of " + sizeOf(test) + " and " + sizeOf(reference) +
                    " pixels cannot be compared; make them of one size");
    requirePixels(test);
    double sum = 0.0;
    for (size_t i = 0; i < test.pixels.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
            sum += relativeSquaredError(test.pixels[i][channel], reference.pixels[i][channel]);
    return sum / (3.0 * static_cast<double>(test.pixels.size()));
}

Image boxDownsample(const Image& image, uint32_t factor) {
    if (factor == 0 || image.width % factor != 0 || image.height % factor != 0)
        throw Error("a picture of " + sizeOf(image) + " pixels cannot be made " +
                    std::to_string(factor) + " times smaller; use a divisor of both sides");
    Image small(image.width / factor, image.height / factor);
    const double share = 1.0 / (static_cast<double>(factor) * factor);
    for (uint32_t y = 0; y < small.height; ++y)
        for (uint32_t x = 0; x < small.width; ++x) {
            glm::dvec3 sum(0.0);
            for (uint32_t dy = 0; dy < factor; ++dy)
                for (uint32_t dx = 0; dx < factor; ++dx)
                    sum += glm::dvec3(image.at(x * factor + dx, y * factor + dy));
            small.at(x, y) = glm::vec3(sum * share);
        }
    return small;
}

} // namespace calotype
