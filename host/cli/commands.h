#pragma once

#include "cli/options.h"

namespace calotype {

/// The program's commands. Each returns an exit code, or throws one of base/error.h.
int renderCommand(const RenderOptions& options);
int infoCommand(const InfoOptions& options);
int compareCommand(const CompareOptions& options);
int benchCommand(const BenchOptions& options);
int devicesCommand(const DeviceOptions& options);

} // namespace calotype
