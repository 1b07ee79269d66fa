#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "study/study.h"

namespace calotype {

/// A variant relative to the usual settings.
struct Comparison {
    std::optional<double> timePerSample; ///< ratio to the usual settings
    std::optional<double> error;         ///< ratio, with the same number of samples
    /// Ratio of the times to the same error; none for variants that lose light.
    std::optional<double> time;
};
Comparison compare(const Measurement& variant, const Measurement& usual);

/// A few sentences on the time and the error of the variant. Ratios of time whose logarithm is
/// smaller than `noise` count as equal.
std::string sentenceOf(const Measurement& variant, const Measurement& usual, double noise);

/// The recommended settings for an error.
struct Choice {
    double target = 0.0;
    bool isDenoised = false;                  ///< the error is that after denoising
    const Measurement* measurement = nullptr; ///< null: no variant reaches the error
    double seconds = 0.0;                     ///< of sampling, in the study's size
    bool isExtrapolated = false;              ///< the seconds: no render was so long
    std::optional<double> usual;              ///< seconds that the usual settings need
    std::string options;                      ///< of the command line; empty for the usual settings
};

inline constexpr std::array kTargets = {0.05, 0.02, 0.01};

/// What is said instead of the settings of a choice that has none.
std::string whyNone(const Choice& choice);

/// The command that renders to the error of the choice by its settings. `command` renders the scene
/// with the usual ones.
std::string commandOf(const Choice& choice, const std::string& command);

/// For each of kTargets: the usual settings unless another variant needs less time by more than
/// Study::timingNoise, and the light that it loses is less than half of the error.
std::vector<Choice> choicesOf(const Study& study);

/// For each of kTargets: the variant with a denoiser that is soonest there, if any is. Empty if
/// none was measured.
std::vector<Choice> denoisedChoicesOf(const Study& study);

} // namespace calotype
