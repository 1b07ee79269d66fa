#pragma once

#include <limits>

#include "settings/light_choice.h"

namespace calotype {

/// Settings of light transport. Except the clamp and the hidden background, they do not change the
/// expected picture.
struct TransportSettings {
    /// Whether multiple importance sampling weights light that both strategies can find; if not,
    /// such light counts only if light sampling found it.
    bool usesMis = true;
    /// Whether paths that carry little light end early, at random.
    bool usesRoulette = true;
    /// Limit of one contribution of light scattered twice or more, for each channel, W/(m^2 sr);
    /// infinite for no limit. It darkens the picture.
    float indirectClamp = std::numeric_limits<float>::infinity();

    LightChoice lightChoice = LightChoice::Power;

    /// Whether rays from the camera that leave the scene show nothing: no light, and alpha 0. The
    /// background still lights the scene, and is seen in mirrors and through glass.
    bool hidesBackground = false;

    bool clampsIndirect() const { return indirectClamp < std::numeric_limits<float>::infinity(); }
};

} // namespace calotype
