#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace calotype {

/// What this version understands of one material of an MTL file.
struct MtlMaterial {
    glm::dvec3 color{0.5};             ///< Kd, as written: may exceed 1
    glm::dvec3 emission{0.0};          ///< Ke
    std::set<std::string> unsupported; ///< statements with an effect that is not rendered
};

/// Reads the text of the MTL file at `path` (the name for messages). Throws SceneError at
/// "PATH:LINE" for a Kd or Ke that is not one or three numbers of 0 or greater.
std::map<std::string, MtlMaterial> parseMtl(std::string_view text, const std::string& path);

} // namespace calotype
