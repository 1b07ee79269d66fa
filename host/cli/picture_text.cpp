#include "cli/picture_text.h"

#include <cstdio>

#include "base/number_text.h"

namespace calotype {

std::string errorText(const CleanPicture& clean) {
    return clean.error ? "error " + withBoundText(*clean.error) : unstatedText(clean.whyUnstated);
}

std::string withBoundText(const DenoisedError& error) {
    return percentText(error.relative) + " (at most " + percentText(error.bound) + ")";
}

std::string unstatedText(const std::string& why) { return "error not stated: " + why; }

std::string exposureText(float stops) {
    char text[80];
    std::snprintf(text, sizeof(text),
                  "exposure: %.1f stops; --exposure %.1f gives the same picture", stops, stops);
    return text;
}

} // namespace calotype
