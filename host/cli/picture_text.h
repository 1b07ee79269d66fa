#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/picture_denoiser.h"
#include "film/display_transform.h"

namespace calotype {

/// "error 12.1 % (at most 12.9 %)", or "error not stated: too few samples to tell".
std::string errorText(const CleanPicture& clean);

/// "12.1 % (at most 12.9 %)".
std::string withBoundText(const DenoisedError& error);

/// "error not stated: too few samples to tell".
std::string unstatedText(const std::string& why);

/// Prints "exposure: 1.3 stops; --exposure 1.3 gives the same picture" on standard error, if there
/// is a PNG among the outputs, and its exposure was chosen.
void printExposure(const std::vector<std::string>& outputs, const std::optional<float>& chosen);

/// The exposure of `shown`, if `wanted` leaves it to the picture.
std::optional<float> chosenExposure(const DisplayTransform& wanted, const DisplayTransform& shown);

} // namespace calotype
