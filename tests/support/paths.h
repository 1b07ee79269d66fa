#pragma once

namespace calotype::test {

extern const char* const kProjectFolder; ///< the root of the project's sources, absolute
extern const char* const kProgram;       ///< the calotype program under test, absolute
extern const char* const kFakeDenoiser;  ///< the library of support/denoiser, absolute

} // namespace calotype::test
