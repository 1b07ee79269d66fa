#pragma once

namespace calotype {

/// What the program tells the shell.
enum ExitCode : int {
    kExitDone = 0,
    kExitOther = 1,   ///< interrupted, an output that cannot be written, anything else
    kExitUsage = 2,   ///< wrong command line
    kExitScene = 3,   ///< bad scene or input file
    kExitDevice = 4,  ///< device or driver
    kExitDiffers = 5, ///< the pictures compared differ by more than is allowed
};

} // namespace calotype
