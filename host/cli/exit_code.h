#pragma once

namespace calotype {

/// Exit codes of the program.
enum ExitCode : int {
    kExitDone = 0,
    kExitOther = 1,   ///< interrupted, an output that cannot be written, anything else
    kExitUsage = 2,   ///< wrong command line
    kExitScene = 3,   ///< bad scene or input file
    kExitDevice = 4,  ///< device or driver
    kExitDiffers = 5, ///< the compared pictures differ by more than is allowed
};

} // namespace calotype
