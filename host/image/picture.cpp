#include "image/picture.h"

#include <algorithm>
#include <utility>

namespace calotype {

std::span<const float> Picture::alpha() const {
    const auto found = std::ranges::find(channels, kAlphaChannel, &Channel::name);
    const auto* values =
        found == channels.end() ? nullptr : std::get_if<std::vector<float>>(&found->pixels);
    return values ? std::span<const float>(*values) : std::span<const float>();
}

void Picture::setAlpha(std::vector<float> values) {
    if (!values.empty())
        channels.push_back({std::string(kAlphaChannel), std::move(values)});
}

} // namespace calotype
