#include "support/paths.h"

namespace calotype::test {

const char* const kProjectFolder = CALOTYPE_SOURCE_DIR;
const char* const kProgram = CALOTYPE_PROGRAM;
const char* const kFakeDenoiser = CALOTYPE_FAKE_DENOISER;

} // namespace calotype::test
