#pragma once

#include <cstdint>
#include <limits>

namespace calotype {

/// How light is looked for along a path. All but the clamp leave the expected picture as it is.
struct TransportSettings {
    /// Whether light found by both strategies is shared between them by multiple importance
    /// sampling; else light that sampling lights could have found counts only where that found it.
    bool usesMis = true;
    /// Whether paths that carry little light end early, by chance.
    bool usesRoulette = true;
    /// The most that one contribution of light scattered twice or more may bring in any channel,
    /// W/(m^2 sr); infinite for no limit. It darkens the picture.
    float indirectClamp = std::numeric_limits<float>::infinity();

    bool clampsIndirect() const { return indirectClamp < std::numeric_limits<float>::infinity(); }
};

/// Which light a path asks for at each event.
enum class LightChoice : uint8_t {
    Power,   ///< one, chosen by what the lights send out
    Uniform, ///< one, each as often as any other
    All,     ///< one after the other, as in the report; known to the reference tracer only
};

/// As users spell it.
inline const char* nameOf(LightChoice choice) {
    switch (choice) {
    case LightChoice::Uniform:
        return "uniform";
    case LightChoice::All:
        return "all";
    case LightChoice::Power:
        break;
    }
    return "power";
}

} // namespace calotype
