#pragma once

#include "cli/options.h"

namespace calotype {

/// The program's commands. Each returns an exit code, or throws one of base/error.h.
int renderCommand(const RenderOptions& options);
int infoCommand(const InfoOptions& options); ///< for a scene; for a film it calls filmInfoCommand
int filmInfoCommand(const InfoOptions& options); ///< the path must be that of a film
int mergeCommand(const MergeOptions& options);
int denoiseCommand(const DenoiseOptions& options);
int compareCommand(const CompareOptions& options);
int studyCommand(const StudyOptions& options);
int benchCommand(const BenchOptions& options);
int devicesCommand(const DevicesOptions& options);
int schemaCommand(); ///< prints the JSON schema of scene files

} // namespace calotype
