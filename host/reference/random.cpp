#include "reference/random.h"

#include <array>

namespace calotype::reference {
namespace {

using Words = std::array<uint32_t, 4>;

constexpr uint32_t kCameraGroup = 0;
constexpr uint32_t kFirstBounceGroup = 8;
constexpr uint32_t kGroupsPerBounce = 8;

/// One round of mixing: adds to each word the product of two others.
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

uint32_t reversed(uint32_t bits) {
    uint32_t result = 0;
    for (uint32_t i = 0; i < 32; ++i)
        result |= (bits >> i & 1u) << (31 - i);
    return result;
}

/// The fraction, as 32 bits, scrambled like Owen's permutation trees, by a hash (Burley 2020,
/// "Practical Hash-based Owen Scrambling", with the constants of Vegdahl 2021).
uint32_t owenScrambled(uint32_t fraction, uint32_t seed) {
    uint32_t x = reversed(fraction);
    x ^= x * 0x3D20ADEAu;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526C56u;
    x ^= x * 0x53A22864u;
    return reversed(x);
}

/// Sobol's second dimension, whose direction numbers are those of the polynomial x + 1.
uint32_t sobolY(uint32_t index) {
    uint32_t y = 0;
    for (uint32_t direction = 1u << 31; index != 0; index >>= 1, direction ^= direction >> 1)
        y ^= (index & 1u) != 0 ? direction : 0;
    return y;
}

/// Blocks of 16 samples belong to eight replicas in turn; each replica has its own index.
glm::dvec2 sobolPoint(const SampleId& id, uint32_t use) {
    constexpr uint32_t kBlock = 16;
    constexpr uint32_t kReplicas = 8;
    const uint32_t block = id.sampleIndex / kBlock;
    const uint32_t index = block / kReplicas * kBlock + id.sampleIndex % kBlock;
    const Words seeds =
        hash({id.pixel.x | id.pixel.y << 16, block % kReplicas, 0x80000000u + use, id.seed});
    const uint32_t order = owenScrambled(index, seeds[0]);
    return {fraction(owenScrambled(reversed(order), seeds[1])),
            fraction(owenScrambled(sobolY(order), seeds[2]))};
}

glm::dvec4 numbers(const SampleId& id, uint32_t group) {
    return id.sampler == Sampler::Sobol
               ? glm::dvec4(sobolPoint(id, 2 * group), sobolPoint(id, 2 * group + 1))
               : fractions(hash(id, group));
}

uint32_t bounceGroup(uint32_t bounce, BounceDimension dimension) {
    return kFirstBounceGroup + kGroupsPerBounce * bounce + static_cast<uint32_t>(dimension);
}

} // namespace

glm::dvec4 cameraNumbers(const SampleId& id) { return numbers(id, kCameraGroup); }

glm::dvec4 bounceNumbers(const SampleId& id, uint32_t bounce, BounceDimension dimension) {
    return numbers(id, bounceGroup(bounce, dimension));
}

glm::dvec4 lightNumbers(const SampleId& id, uint32_t bounce, uint32_t light) {
    const Words w = hash(id, bounceGroup(bounce, BounceDimension::Light));
    return fractions(hash({w[0], w[1], w[2], light}));
}

double alphaNumber(const SampleId& id, uint32_t bounce, uint32_t item) {
    const Words w = hash(id, bounceGroup(bounce, BounceDimension::Alpha));
    return fraction(hash({w[0], w[1], w[2], item})[0]);
}

} // namespace calotype::reference
