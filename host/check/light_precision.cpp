#include "check/light_precision.h"

#include <algorithm>
#include <vector>

#include "check/emitters.h"

namespace calotype {
namespace {

/// Relative to the brightest light. A film rounds sums of 16 samples to 2^-64 of a unit, up to
/// twice that light. So a picture of a light this faint alone has an error of up to 2^-14.
constexpr double kFaintest = 0x1p-54;

} // namespace

void warnOfLightPrecision(const Scene& scene, Warnings& warnings) {
    const std::vector<Emitter> emitters = emittersOf(scene);
    double brightest = 0.0;
    for (const Emitter& emitter : emitters)
        brightest = std::max(brightest, emitter.brightest);
    for (const Emitter& emitter : emitters) {
        if (emitter.brightest > 0.0 && emitter.brightest < kFaintest * brightest) {
            warnings.add(emitter.place,
                         emitter.subject +
                             "shines with less than 5e-17 of the radiance of the brightest "
                             "light, beside which the film loses it; render the two in "
                             "pictures of their own and add these",
                         "lights that are too faint");
        }
    }
}

} // namespace calotype
