#pragma once

#include <cstdint>

namespace calotype {

/// Which light is sampled at each scattering event of a path.
enum class LightChoice : uint8_t {
    Power,   ///< one, chosen by the power of the lights
    Tree,    ///< one, chosen by what it may contribute to the point, through a tree
    Uniform, ///< one, each with the same probability
    All,     ///< all, one after the other; only in the reference tracer
};

/// The name in options.
constexpr const char* nameOf(LightChoice choice) {
    switch (choice) {
    case LightChoice::Tree:
        return "tree";
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
