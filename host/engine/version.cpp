#include "engine/version.h"

namespace calotype {

std::string versionText() {
    const std::string commit = CALOTYPE_COMMIT; // from cmake/Commit.cmake
    return CALOTYPE_VERSION + (commit.empty() ? "" : " (commit " + commit + ")");
}

} // namespace calotype
