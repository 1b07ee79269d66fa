#pragma once

namespace calotype {

/// Exit codes of the program.
enum ExitCode : int {
    kExitDone = 0,
    kExitOther = 1,   ///< interrupted, or anything else
    kExitUsage = 2,   ///< wrong command line
    kExitScene = 3,   ///< bad scene or input file
    kExitDevice = 4,  ///< device or driver
    kExitDiffers = 5, ///< not as required: pictures differ by too much, or films lack samples
    kExitOutput = 6,  ///< an output that cannot be written
    kExitBusy = 7,    ///< another process writes an output
};

} // namespace calotype
