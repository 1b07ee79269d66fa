#pragma once

namespace calotype {

/// Reads the command line and runs the command. Errors become one sentence on standard error and an
/// ExitCode.
int runCommandLine(int argc, char** argv);

} // namespace calotype
