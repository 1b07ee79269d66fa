#pragma once

#include <array>
#include <string>

#include "shared/scene_structs.h"
#include "support/random_numbers.h"

namespace calotype::test {

/// How a test ray is aimed at a quadric.
enum class RayKind {
    Outside,         ///< from up to 10 sizes away, at its surroundings
    Far,             ///< from 10 to 1000 sizes away
    Inside,          ///< from inside
    Grazing,         ///< along a tangent, 1e-9 to 1e-2 sizes off it
    WorldAxis,       ///< along an axis of the world, with zeros of both signs
    LocalAxis,       ///< along an axis of the quadric
    NearlyLocalAxis, ///< tilted against the quadric's axis by 1e-20 to 1e-6
    Apex,            ///< at the apex, or at the centre
    SideLine,        ///< parallel to a line of a cone's side
    Rim,             ///< at the rim
    FacePlane,       ///< in the plane of a cap, of the base, of the disk
    OnSurface,       ///< from a point that is on the surface but for rounding
};
inline constexpr std::array kAllRayKinds = {
    RayKind::Outside,   RayKind::Far,       RayKind::Inside,          RayKind::Grazing,
    RayKind::WorldAxis, RayKind::LocalAxis, RayKind::NearlyLocalAxis, RayKind::Apex,
    RayKind::SideLine,  RayKind::Rim,       RayKind::FacePlane,       RayKind::OnSurface};

std::string nameOf(RayKind kind);

struct AimedRay {
    glm::dvec3 origin;
    glm::dvec3 direction; ///< every other one unit length, the others 1e-3 to 1e3
};
AimedRay aimRay(RayKind kind, const shared::Quadric& quadric, RandomNumbers& random);

} // namespace calotype::test
