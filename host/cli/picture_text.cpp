#include "cli/picture_text.h"

#include <algorithm>
#include <cstdio>

#include "base/number_text.h"
#include "image/image_format.h"

namespace calotype {

std::string errorText(const CleanPicture& clean) {
    return clean.error ? "error " + withBoundText(*clean.error) : unstatedText(clean.whyUnstated);
}

std::string withBoundText(const DenoisedError& error) {
    return percentText(error.relative) + " (at most " + percentText(error.bound) + ")";
}

std::string unstatedText(const std::string& why) { return "error not stated: " + why; }

void printExposure(const std::vector<std::string>& outputs, const std::optional<float>& chosen) {
    const auto isPng = [](const std::string& path) {
        return imageFormatOf(path) == ImageFormat::Png;
    };
    if (chosen && std::ranges::any_of(outputs, isPng))
        std::fprintf(stderr, "exposure: %.1f stops; --exposure %.1f gives the same picture\n",
                     *chosen, *chosen);
}

std::optional<float> chosenExposure(const DisplayTransform& wanted, const DisplayTransform& shown) {
    return wanted.exposureStops ? std::nullopt : shown.exposureStops;
}

} // namespace calotype
