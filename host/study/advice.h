#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "study/study.h"

namespace calotype {

/// What a variant costs and gives beside the usual settings.
struct Comparison {
    std::optional<double> timePerSample; ///< of the variant, over that of the usual settings
    std::optional<double> error;         ///< at as many samples, likewise
    /// To the same error, likewise; not of what loses light.
    std::optional<double> time;
};
Comparison compare(const Measurement& variant, const Measurement& usual);

/// A sentence or two: what the variant costs and gives. Shares of time below `noise` tell nothing.
std::string sentenceOf(const Measurement& variant, const Measurement& usual, double noise);

/// What a study would choose to reach an error.
struct Choice {
    double target = 0.0;
    const Measurement* measurement = nullptr; ///< null: nothing gets there
    double seconds = 0.0;                     ///< of sampling, in the study's size
    std::optional<double> usual;              ///< that the usual settings would take
};

inline constexpr std::array kTargets = {0.05, 0.02, 0.01};

/// For each of kTargets: the usual settings unless another variant needs less time by more than
/// Study::timingNoise, and what light it loses is less than half of the error.
std::vector<Choice> choicesOf(const Study& study);

} // namespace calotype
