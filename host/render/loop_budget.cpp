#include "render/loop_budget.h"

namespace calotype {

/// llvmpipe, the CPU driver, grants the invocations of a subgroup 65,535 loop iterations together
/// and then silently skips loop bodies; the rest is for those that end a dispatch. A GPU only has
/// to come back in time.
uint32_t loopBudget(const Device& device) {
    return device.info().type == "CPU" ? 60'000 : 1'000'000;
}

} // namespace calotype
