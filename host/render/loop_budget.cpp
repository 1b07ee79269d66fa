#include "render/loop_budget.h"

namespace calotype {
namespace {

bool isCpu(const Device& device) { return device.info().type == "CPU"; }

} // namespace

/// llvmpipe, the CPU driver, grants the invocations of a subgroup 65,535 loop iterations together
/// and then silently skips loop bodies; the margin is for what one scattering event may take. A GPU
/// only has to come back in time.
LoopBudget loopBudget(const Device& device) {
    return isCpu(device) ? LoopBudget{30'000, 50'000} : LoopBudget{1'000'000, UINT32_MAX};
}

/// An event sends two rays. The SAH cost is what one line tests on average; the slowest of a
/// subgroup, for which all others wait, takes half as much again (measured), and each ray three
/// iterations and the event eight besides.
std::optional<uint32_t> bouncesBeforeCut(const Device& device, const BvhStatistics& bvh) {
    if (!isCpu(device))
        return std::nullopt;
    const double iterationsPerEvent = 2.0 * (1.5 * bvh.sahCost + 3.0) + 8.0;
    return static_cast<uint32_t>(loopBudget(device).beforeCut / iterationsPerEvent);
}

} // namespace calotype
