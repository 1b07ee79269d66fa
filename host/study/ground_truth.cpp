#include "study/ground_truth.h"

#include <cmath>
#include <limits>

#include "film/error_estimate.h"
#include "math/luminance.h"
#include "math/square.h"

namespace calotype {
GroundTruth::GroundTruth(Session& session) : picture(session.picture()) {
    for (const glm::vec3& pixel : picture.pixels)
        luminances.push_back(luminance(glm::dvec3(pixel)));
    const MeanLuminance all = meanLuminance(picture, session.pixelErrors());
    mean = all.mean;
    meanError = all.standardError;
    const auto& estimate = session.error();
    error = estimate ? estimate->relative : std::numeric_limits<double>::infinity();
    isTrusted = estimate && estimate->isTrusted();
    samples = session.totals().samplesPerPixel;
    seconds = session.totals().seconds;
}

std::optional<double> GroundTruth::errorOf(const Image& image) const {
    double sum = 0.0;
    for (size_t i = 0; i < luminances.size(); ++i) {
        const double deviation = luminance(glm::dvec3(image.pixels[i])) - luminances[i];
        sum += relativeShare(square(deviation), luminances[i], mean);
    }
    const double measured = relativeError(sum / static_cast<double>(luminances.size()));
    const double left = square(measured) - square(error);
    if (!(left > square(error))) // it cannot measure errors below its own
        return std::nullopt;
    return std::sqrt(left);
}

MeanLuminance meanLuminance(const Image& image, const std::vector<PixelError>& errors) {
    double sum = 0.0;
    double variance = 0.0;
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        sum += luminance(glm::dvec3(image.pixels[i]));
        variance += square(errors[i].standardError);
    }
    const auto count = static_cast<double>(image.pixels.size());
    return {sum / count, std::sqrt(variance) / count};
}

} // namespace calotype
