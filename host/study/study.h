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

struct StudyPlan {
    StudySettings usual;    ///< those of the scene, in its size
    double seconds = 0.0;   ///< for all of it
    bool keepsSize = false; ///< else the picture may be made smaller, so that there is time for it
};

/// What a study hears and tells while it runs.
struct StudyObserver {
    std::function<bool()> shouldStop;
    std::function<void(const std::string& what)> onProgress; ///< about ten times a second
};

/// The middle of a picture, at most 256 pixels on a side, its pixels as they are: what pages show.
Image middleOf(const Image& image);

/// What a study found.
struct Study {
    StudySettings usual; ///< in the size of the study
    double scale = 1.0;  ///< pixels of the scene's picture to one of the study's
    std::optional<Reference> reference;
    std::vector<Measurement> measurements; ///< the usual settings first
    bool isWhole = false;                  ///< else it was stopped
};

/// Renders a reference in two fifths of the time, each variant for as long as any other in the
/// rest, and last, where several changes were for the better, these together. Between variants the
/// usual settings render a little more: how fast they do tells the machine's pace, by which all
/// seconds are corrected. A study that is stopped holds what was whole by then. Throws Error where
/// the picture is black, or the time too short for a reference.
Study runStudy(const StudyPlan& plan, const PrepareTracer& prepare, const StudyObserver& observer);

} // namespace calotype
