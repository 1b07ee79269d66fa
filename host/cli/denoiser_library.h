#pragma once

#include <string>

namespace calotype {

/// Where Open Image Denoise is: what the environment variable CALOTYPE_OIDN names; or else, if it
/// is not beside the program, that of Python's package pyoidn in the active virtual environment,
/// the user's packages or the system's. Empty where there is none of these.
std::string denoiserLibrary();

} // namespace calotype
