#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "film/error_estimate.h"
#include "math/luminance.h"

namespace calotype::test {

/// Luminances of one picture, with what it says of their errors.
struct JudgedPicture {
    std::vector<double> luminances;
    std::vector<PixelError> errors;
    ErrorEstimate estimate;
};

/// Of a film or an adaptive one, large enough for an estimate.
template <typename AnyFilm>
JudgedPicture judge(const AnyFilm& film) {
    JudgedPicture judged;
    for (const glm::vec3& pixel : film.picture().pixels)
        judged.luminances.push_back(luminance(glm::dvec3(pixel)));
    judged.errors = pixelErrors(film);
    judged.estimate = *estimateError(film);
    return judged;
}

inline double mean(const std::vector<double>& numbers) {
    double sum = 0.0;
    for (const double number : numbers)
        sum += number;
    return sum / static_cast<double>(numbers.size());
}

/// Pixel by pixel, the mean of all pictures but `left`; or of all.
inline std::vector<double> meanOfOthers(const std::vector<JudgedPicture>& pictures,
                                        const JudgedPicture* left = nullptr) {
    std::vector<double> mean(pictures[0].luminances.size());
    const size_t count = pictures.size() - (left ? 1 : 0);
    for (const JudgedPicture& picture : pictures)
        for (size_t i = 0; i < mean.size() && &picture != left; ++i)
            mean[i] += picture.luminances[i] / static_cast<double>(count);
    return mean;
}

/// Sum of the squares of a picture's true relative errors, as ErrorEstimate::relative has them,
/// over the number of pixels.
inline double trueSquare(const JudgedPicture& picture, const std::vector<double>& truth) {
    const double floor = 0.01 * mean(truth);
    double sum = 0.0;
    for (size_t i = 0; i < truth.size(); ++i)
        sum +=
            std::pow(picture.luminances[i] - truth[i], 2.0) / (truth[i] * truth[i] + floor * floor);
    return sum / static_cast<double>(truth.size());
}

/// Counts pixels whose error lies within what is stated. Those without noise are not counted.
struct Coverage {
    double within = 0.0;
    double all = 0.0;

    /// `noise` is the truth's own variance, as a share of the picture's.
    void add(const JudgedPicture& picture, const std::vector<double>& truth, double noise) {
        for (size_t i = 0; i < truth.size(); ++i) {
            const double distance = std::abs(picture.luminances[i] - truth[i]);
            const double interval = picture.errors[i].interval;
            if (interval <= 1e-6 * truth[i])
                continue;
            within += distance <= interval * std::sqrt(1.0 + noise) ? 1.0 : 0.0;
            all += 1.0;
        }
    }

    double share() const { return within / all; }
};

} // namespace calotype::test
