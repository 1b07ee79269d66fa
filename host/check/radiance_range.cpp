#include "check/radiance_range.h"

#include "base/error.h"
#include "check/emitters.h"
#include "scene/ranges.h"

namespace calotype {

void requireRadianceInRange(const Scene& scene) {
    for (const Emitter& emitter : emittersOf(scene)) {
        const double largest = emitter.brightest;
        if (largest != 0.0 && !ranges::kEmitter.contains(largest)) {
            throw SceneError(emitter.place,
                             emitter.subject +
                                 "emits a radiance that is neither 0 nor from 1e-30 to 1e30 "
                                 "W/(m^2 sr); scale all lights alike, and the exposure back");
        }
    }
}

} // namespace calotype
