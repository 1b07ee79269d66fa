#include "engine/render_plan.h"

#include <algorithm>
#include <cmath>

namespace calotype {

double shareDone(const RenderPlan& plan, const RenderTotals& totals, double seconds) {
    double done = 0.0;
    const auto paths = static_cast<double>(totals.paths);
    if (plan.samplesPerPixel && *plan.samplesPerPixel > plan.samplesBefore)
        done =
            paths / static_cast<double>(plan.pixels * (*plan.samplesPerPixel - plan.samplesBefore));
    if (plan.seconds)
        done = std::max(done, seconds / *plan.seconds);
    if (plan.targetError && totals.error) {
        // Errors fall with the square root of the samples and are checked at each doubling.
        const auto now = static_cast<double>(totals.samplesPerPixel);
        const double needed = now * std::pow(totals.error->relative / *plan.targetError, 2.0);
        const double look = std::max(128.0, std::exp2(std::ceil(std::log2(std::max(1.0, needed)))));
        const auto before = static_cast<double>(plan.samplesBefore);
        if (look > before)
            done = std::max(done, paths / (static_cast<double>(plan.pixels) * (look - before)));
    }
    return std::clamp(done, 0.0, 1.0);
}

} // namespace calotype
