#include "render/loop_budget.h"

namespace calotype {

/// llvmpipe, the CPU driver, allows the invocations of a subgroup 65,535 loop iterations in total
/// and then silently skips loop bodies. The rest of these is for the loops that end a dispatch. A
/// GPU must only finish in time.
uint32_t loopBudget(const Device& device) {
    return device.info().type == "CPU" ? 60'000 : 1'000'000;
}

} // namespace calotype
