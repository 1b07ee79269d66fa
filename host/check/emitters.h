#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace calotype {

/// Something that emits light: the background, or a material.
struct Emitter {
    double brightest = 0.0; ///< the largest channel of its radiance, W/(m^2 sr); may be 0
    std::string place;      ///< in the scene file, for messages
    std::string subject;    ///< the beginning of a message: "the material "lamp" ", or empty
};

/// All that may emit light in the scene: the background first, then the materials that shapes use.
std::vector<Emitter> emittersOf(const Scene& scene);

} // namespace calotype
