#pragma once

#include <string>

#include "engine/picture_denoiser.h"

namespace calotype {

/// "error 12.1 % (at most 12.9 %)", or "error not stated: too few samples to tell".
std::string errorText(const CleanPicture& clean);

/// "12.1 % (at most 12.9 %)".
std::string withBoundText(const DenoisedError& error);

/// "error not stated: too few samples to tell".
std::string unstatedText(const std::string& why);

/// "exposure: 1.3 stops; --exposure 1.3 gives the same picture".
std::string exposureText(float stops);

} // namespace calotype
