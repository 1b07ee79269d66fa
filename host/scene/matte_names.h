#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace calotype {

/// Names of what mattes tell apart, and which of them each primitive belongs to.
struct MatteNames {
    std::vector<std::string> names;     ///< all different, in UTF-8
    std::vector<uint32_t> ofPrimitives; ///< index into `names`, in the order of the scene
};

/// By objects: the names of shapes; "shape 7" for the shape of that index if it has none.
MatteNames objectNames(const Scene& scene);

/// By materials; "material 7" for the material of that index if it has no name.
MatteNames materialNames(const Scene& scene);

} // namespace calotype
