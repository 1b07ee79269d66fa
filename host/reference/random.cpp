#include "reference/random.h"

#include <array>

namespace calotype::reference {
namespace {

using Words = std::array<uint32_t, 4>;

constexpr uint32_t kCameraGroup = 0;
constexpr uint32_t kFirstBounceGroup = 4;
constexpr uint32_t kGroupsPerBounce = 4;

/// One round of mixing: each word takes in the product of two others.
void mix(Words& w) {
    w[0] += w[1] * w[3];
    w[1] += w[2] * w[0];
    w[2] += w[0] * w[1];
    w[3] += w[1] * w[2];
}

/// pcg4d (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering").
Words hash(Words w) {
    for (uint32_t& word : w)
        word = word * 1664525u + 1013904223u;
    mix(w);
    for (uint32_t& word : w)
        word ^= word >> 16;
    mix(w);
    return w;
}

Words hash(const SampleId& id, uint32_t group) {
    return hash({id.pixel.x | id.pixel.y << 16, id.sampleIndex, group, id.seed});
}

/// The upper 24 bits as a fraction.
double fraction(uint32_t word) { return (word >> 8) / 16777216.0; }

glm::dvec4 fractions(const Words& w) {
    return {fraction(w[0]), fraction(w[1]), fraction(w[2]), fraction(w[3])};
}

uint32_t bounceGroup(uint32_t bounce, BounceDimension dimension) {
    return kFirstBounceGroup + kGroupsPerBounce * bounce + static_cast<uint32_t>(dimension);
}

} // namespace

glm::dvec4 cameraNumbers(const SampleId& id) { return fractions(hash(id, kCameraGroup)); }

glm::dvec4 bounceNumbers(const SampleId& id, uint32_t bounce, BounceDimension dimension) {
    return fractions(hash(id, bounceGroup(bounce, dimension)));
}

double alphaNumber(const SampleId& id, uint32_t bounce, uint32_t item) {
    const Words w = hash(id, bounceGroup(bounce, BounceDimension::Alpha));
    return fraction(hash({w[0], w[1], w[2], item})[0]);
}

} // namespace calotype::reference
