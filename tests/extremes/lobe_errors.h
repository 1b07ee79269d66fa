#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "support/kernels/test_structs.h"
#include "support/random_numbers.h"

/// Opaque materials down to the plane of the surface: views whose cosine is anything from 1e-6 to
/// 1, each decade alike.
namespace calotype::test {

/// Of many events on many materials, the worst.
struct LobeErrors {
    uint64_t events = 0;
    uint64_t notFinite = 0;      ///< with a number in their answer that is none
    double roundoffs = 0.0;      ///< n of addValues, or of addSamples
    std::string worst;           ///< the event of that, for messages
    double greatestWeight = 0.0; ///< of one sample
    uint64_t tipped = 0;         ///< samples that go elsewhere than the reference's
    uint64_t unexplained = 0;    ///< tipped samples that rounding does not send there
    double meanDifference = 0.0; ///< of a material's mean weight where float resolves the lobe
};

/// Value and density at `count` pairs of directions, given in the frame of the surface, by backward
/// error: they are right if they are those of two directions that each lie within n 2^-23 of the
/// given ones, but for n roundings of the arithmetic. The half vector is a lobe's only measure of
/// them, and turns by that over |wo + wi|. The smallest power of two for n is found.
void addValues(const Material& material, double lobeWidth, size_t count, RandomNumbers& random,
               LobeErrors& errors);

enum class SurfaceFrame { Upright, Turned };

/// `count` samples by random numbers, the ends of their range among them, against the reference
/// tracer's of the same numbers and directions; the surface lies in the world's z plane, or in any.
/// Weights may be off by the share n 2^-23 (1 / wo.z + 1 / wi.z + 1 / (lobeWidth |wo + wi|) + 1 /
/// c) of themselves, or of 1: rounding moves cosines, turns half vectors by what a lobe of that
/// width feels, and c is the smaller of two lobes' chances. A lobe is resolved where that stays
/// below a thousandth for n = 1. Tipped are samples of which only one of the two leaves the
/// surface, or leaves it elsewhere. Rounding explains those that the reference's go to from a
/// view and numbers within 8 2^-23 of the given ones, and the loss of those whose density
/// underflows in float for a direction that near.
void addSamples(const Material& material, double lobeWidth, SurfaceFrame frame, size_t count,
                RandomNumbers& random, LobeErrors& errors);

std::ostream& operator<<(std::ostream& out, const LobeErrors& errors);

} // namespace calotype::test
