#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "settings/denoiser_kind.h"
#include "settings/render_settings.h"
#include "study/ground_truth.h"
#include "study/measurement.h"
#include "study/prepared_tracer.h"
#include "study/variant.h"

namespace calotype {

using PrepareTracer = std::function<PreparedTracer(const RenderSettings&)>;

/// A PrepareTracer may throw this if the user stops the study.
struct StudyStopped {};

/// A variant that was not measured.
struct FailedVariant {
    std::string name;
    std::string reason; ///< a sentence
};

struct StudyPlan {
    RenderSettings usual; ///< those of the scene, at its size; those of variants without a denoiser
    double seconds = 0.0; ///< budget of the whole study
    bool keepsSize = false;   ///< false: the picture may be made smaller to fit the budget
    bool isReference = false; ///< uses the reference tracer: no kernel, and only one kind of tree
    std::vector<DenoiserKind> denoisers = {}; ///< with each of which a variant is measured
    std::vector<FailedVariant> omitted = {};  ///< denoisers that cannot be used here
};

/// Callbacks of a running study.
struct StudyObserver {
    std::function<bool()> shouldStop;
    std::function<void(const std::string& what)> onProgress; ///< about ten times a second
};

enum class StudyEnding : uint8_t {
    Whole,
    Stopped,   ///< by the user
    OutOfTime, ///< before all variants were measured
};

/// The results of a study.
struct Study {
    RenderSettings usual; ///< at the picture size of the study, without a denoiser
    /// The scene's settings name a denoiser, so that a render without one needs --denoise off.
    bool needsDenoiseOff = false;
    double scale = 1.0; ///< pixels at the scene's own size over pixels of the study's pictures
    std::optional<GroundTruth> groundTruth;
    std::vector<Measurement> measurements; ///< the usual settings first
    std::vector<FailedVariant> failures;
    std::vector<FailedVariant> omitted; ///< that cannot be measured here, or not in this time
    /// Relative standard deviation of the machine's pace between two measurements of it.
    double paceSpread = 0.0;
    StudyEnding ending = StudyEnding::Stopped;

    /// Ratios of time whose logarithm is smaller are within the measurement noise.
    double timingNoise() const;
};

/// Renders the ground truth in two fifths of the time. The variants share the rest equally; those
/// with a denoiser come after the others, last all improvements together, if there are several.
/// Between the variants the usual settings render a little more, which measures the machine's pace;
/// all seconds are corrected by it. A study that is stopped, or out of time, holds the measurements
/// that were complete. Throws Error if the picture is black, the time is too short for the ground
/// truth, or the usual settings cannot be rendered.
Study runStudy(const StudyPlan& plan, const PrepareTracer& prepare, const StudyObserver& observer);

} // namespace calotype
