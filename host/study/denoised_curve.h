#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "film/looks.h"
#include "image/image.h"
#include "render/session.h"
#include "study/ground_truth.h"
#include "study/measurement.h"
#include "study/prepared_tracer.h"

namespace calotype {

/// The curve of a variant whose pictures are denoised: with 128, 256, 512, ... samples per pixel,
/// and in the end. The time of a point is that of sampling, of finding what the denoiser uses, and
/// of denoising once; the time that the curve itself takes includes all its denoising.
class DenoisedCurve {
public:
    /// Keeps references. `seconds`: of which a curve of at least one point takes little more.
    /// `onProgress` is called while it denoises, and may throw.
    DenoisedCurve(const PreparedTracer& prepared, const Session& session, const GroundTruth& truth,
                  double seconds, const std::function<void()>& onProgress)
        : prepared_(prepared), session_(session), truth_(truth), seconds_(seconds),
          onProgress_(onProgress) {}

    /// To be called after each pass.
    void onPass();

    /// Whether sampling should end, so that time is left for denoising once more.
    bool isOver() const;

    /// Adds the last point.
    void finish();

    const std::vector<CurvePoint>& points() const { return points_; }

    /// That of the last point.
    const std::optional<Image>& picture() const { return picture_; }

private:
    double secondsTaken() const;
    void record();

    const PreparedTracer& prepared_;
    const Session& session_;
    const GroundTruth& truth_;
    double seconds_;
    const std::function<void()>& onProgress_;
    std::vector<CurvePoint> points_;
    std::optional<Image> picture_;
    uint64_t next_ = kFirstLook;  ///< samples per pixel of the next point
    uint64_t samples_ = 0;        ///< of all pixels, at the last point
    double denoiseSeconds_ = 0.0; ///< all together
    double lastDenoiseSeconds_ = 0.0;
    bool isTooLong_ = false; ///< denoising takes more than the time that is left
};

} // namespace calotype
