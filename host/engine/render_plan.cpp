#include "engine/render_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "film/looks.h"

namespace calotype {
namespace {

/// The error that the target is compared with, and the samples per pixel of which it is the error:
/// 0 if it is not known.
std::pair<double, uint64_t> errorSoFar(const RenderPlan& plan, const RenderTotals& totals) {
    if (plan.targetsDenoised)
        return {totals.denoised ? totals.denoised->upperBound : 0.0, totals.denoisedSamples};
    if (!totals.error)
        return {0.0, 0};
    return {totals.error->relative, totals.samplesPerPixel};
}

} // namespace

double shareDone(const RenderPlan& plan, const RenderTotals& totals, double seconds) {
    double done = 0.0;
    const auto paths = static_cast<double>(totals.paths);
    if (plan.samplesPerPixel && *plan.samplesPerPixel > plan.samplesBefore)
        done =
            paths / static_cast<double>(plan.pixels * (*plan.samplesPerPixel - plan.samplesBefore));
    if (plan.seconds)
        done = std::max(done, seconds / *plan.seconds);
    if (const auto [error, judged] = errorSoFar(plan, totals); plan.targetError && judged > 0) {
        // Errors fall with the square root of the samples, and are compared at looks.
        constexpr double kMost = 1e15; // any number of samples that no render has
        const double ratio = error / *plan.targetError;
        const auto samples = static_cast<double>(judged);
        const double needed = std::clamp(std::ceil(samples * ratio * ratio), 1.0, kMost);
        const auto look = static_cast<double>(lookAfter(static_cast<uint64_t>(needed) - 1));
        const auto before = static_cast<double>(plan.samplesBefore);
        if (look > before)
            done = std::max(done, paths / (static_cast<double>(plan.pixels) * (look - before)));
    }
    return std::clamp(done, 0.0, 1.0);
}

} // namespace calotype
