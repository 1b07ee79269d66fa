#include "read/reader.h"

#include <array>

#include "read/json/scene.h"
#include "read/obj/model_scene.h"

namespace calotype {

std::span<const SceneReader> sceneReaders() {
    static constexpr std::array<SceneReader, 2> readers = {{
        {".json", readJsonScene},
        {".obj", readModelScene},
    }};
    return readers;
}

} // namespace calotype
