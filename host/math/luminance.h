#pragma once

#include <glm/vec3.hpp>

namespace calotype {

/// The luminance of linear Rec. 709 (ITU-R BT.709, section 3). The weights sum to 1.
inline double luminance(const glm::dvec3& color) {
    return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}

} // namespace calotype
