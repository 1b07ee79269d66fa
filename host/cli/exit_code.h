#pragma once

namespace calotype {

/// What the program tells the shell.
enum ExitCode : int {
    kExitDone = 0,
    kExitOther = 1,  ///< interrupted, an output that cannot be written, anything else
    kExitUsage = 2,  ///< wrong command line
    kExitScene = 3,  ///< bad scene or input file
    kExitDevice = 4, ///< device or driver
};

} // namespace calotype
