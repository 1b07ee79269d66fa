#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/vec3.hpp>

namespace calotype::test {

/// PCG-XSH-RR (O'Neill 2014). The library's own generator and conversions, so that a seeded test
/// sees the same numbers with every compiler.
class RandomNumbers {
public:
    explicit RandomNumbers(uint64_t seed) : state_(seed * kMultiplier + kIncrement) { bits(); }

    uint32_t bits() {
        const uint64_t old = state_;
        state_ = old * kMultiplier + kIncrement;
        const auto shifted = static_cast<uint32_t>(((old >> 18u) ^ old) >> 27u);
        const auto rotation = static_cast<uint32_t>(old >> 59u);
        return (shifted >> rotation) | (shifted << (-rotation & 31u));
    }

    /// In [0, 1), a multiple of 2^-32.
    double unit() { return bits() * 0x1p-32; }

    /// In [0, 1), a multiple of 2^-24, as the kernels' own random numbers.
    float deviceUnit() { return static_cast<float>(bits() >> 8u) * 0x1p-24f; }

    double between(double lower, double upper) { return lower + (upper - lower) * unit(); }

    /// 10^x for x uniform between the two.
    double powerOfTen(double lower, double upper) { return std::pow(10.0, between(lower, upper)); }

    uint32_t below(uint32_t count) { return static_cast<uint32_t>(unit() * count); }

    bool coin() { return (bits() & 1u) != 0; }

    double sign() { return coin() ? 1.0 : -1.0; }

    /// Uniform on the unit sphere.
    glm::dvec3 direction() {
        const double y = between(-1.0, 1.0);
        const double radius = std::sqrt(1.0 - y * y);
        const double phi = 2.0 * std::numbers::pi * unit();
        return {radius * std::cos(phi), y, radius * std::sin(phi)};
    }

    /// Uniform in the unit ball.
    glm::dvec3 inBall() { return direction() * std::cbrt(unit()); }

private:
    static constexpr uint64_t kMultiplier = 6364136223846793005u;
    static constexpr uint64_t kIncrement = 1442695040888963407u;

    uint64_t state_;
};

} // namespace calotype::test
