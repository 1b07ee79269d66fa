#include "check/black_picture.h"

#include <algorithm>

#include "check/emitters.h"

namespace calotype {

void warnOfBlackPicture(const Scene& scene, Warnings& warnings) {
    const auto shines = [](const Emitter& emitter) { return emitter.brightest > 0.0; };
    if (std::ranges::any_of(emittersOf(scene), shines))
        return;
    warnings.add(scene.place,
                 scene.shapes.empty()
                     ? "there are no shapes and no lights, so the picture will be black"
                     : "nothing emits light, so the picture will be black");
}

} // namespace calotype
