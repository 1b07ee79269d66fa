#include <cstdio>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "read/json/scene.h"

namespace calotype {

int schemaCommand() {
    std::fputs(sceneSchema().c_str(), stdout);
    return kExitDone;
}

} // namespace calotype
