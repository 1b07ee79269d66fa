#pragma once

#include <cstdint>

namespace calotype {

/// Which light is sampled at each scattering event of a path.
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
