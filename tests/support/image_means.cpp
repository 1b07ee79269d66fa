#include "support/image_means.h"

#include <string>

#include "base/error.h"

namespace calotype::test {
namespace {

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

Image boxDownsample(const Image& image, uint32_t factor) {
    if (factor == 0 || image.width % factor != 0 || image.height % factor != 0)
        throw Error("a picture of " + sizeText(image) + " pixels cannot be made " +
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

} // namespace calotype::test
