#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/block_tracer.h"
#include "study/measurement.h"
#include "study/reference.h"
#include "study/variant.h"

namespace calotype {

/// A tracer that is ready to render, and what that took.
struct PreparedTracer {
    std::shared_ptr<void> owner; ///< of the tracer
    BlockTracer* tracer = nullptr;
    double maxRadiance = 0.0; ///< W/(m^2 sr)
    double buildSeconds = 0.0;
    double compileSeconds = 0.0;
    std::function<void()> finish = {}; ///< throws what only came to light on the way
};
using PrepareTracer = std::function<PreparedTracer(const StudySettings&)>;

/// What a PrepareTracer may throw where the user stops the study meanwhile.
struct StudyStopped {};

struct StudyPlan {
    StudySettings usual;    ///< those of the scene, in its size
    double seconds = 0.0;   ///< for all of it
    bool keepsSize = false; ///< else the picture may be made smaller, so that there is time for it
    bool isReference = false; ///< by the reference tracer, which has no kernel and one kind of tree
};

/// What a study hears and tells while it runs.
struct StudyObserver {
    std::function<bool()> shouldStop;
    std::function<void(const std::string& what)> onProgress; ///< about ten times a second
};

/// The middle of a picture, at most 256 pixels on a side, its pixels as they are: what pages show.
Image middleOf(const Image& image);

/// A variant that could not be rendered, and why.
struct FailedVariant {
    std::string name;
    std::string reason; ///< a sentence
};

enum class StudyEnding : uint8_t {
    Whole,
    Stopped,   ///< by the user
    OutOfTime, ///< before all variants were measured
};

/// What a study found.
struct Study {
    StudySettings usual; ///< in the size of the study
    double scale = 1.0;  ///< pixels of the scene's picture to one of the study's
    std::optional<Reference> reference;
    std::vector<Measurement> measurements; ///< the usual settings first
    std::vector<FailedVariant> failures;
    /// How much the machine's pace differed between two measurements of it: a standard deviation,
    /// as a share.
    double paceSpread = 0.0;
    StudyEnding ending = StudyEnding::Stopped;

    /// Shares of time that differ by less tell nothing.
    double timingNoise() const;
};

/// Renders a reference in two fifths of the time, each variant for as long as any other in the
/// rest, and last, where several changes were for the better, these together. Between variants the
/// usual settings render a little more: how fast they do tells the machine's pace, by which all
/// seconds are corrected. A study that is stopped, or out of time, holds what was whole by then.
/// Throws Error where the picture is black, the time too short for a reference, or the usual
/// settings cannot be rendered.
Study runStudy(const StudyPlan& plan, const PrepareTracer& prepare, const StudyObserver& observer);

} // namespace calotype
