#include "support/paths.h"

namespace calotype::test {

const char* const kProjectFolder = CALOTYPE_SOURCE_DIR;
const char* const kProgram = CALOTYPE_PROGRAM;

} // namespace calotype::test
