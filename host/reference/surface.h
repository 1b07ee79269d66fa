#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace calotype::reference {

/// The surface data that shading needs where a ray hits a shape, in world space.
struct Surface {
    glm::dvec3 position;
    glm::dvec3 ng;       ///< unit geometric normal, outward: a triangle's front, a disk's normal
    glm::dvec3 ns;       ///< unit shading normal before normal maps, on the side of ng
    glm::dvec3 horizon;  ///< unit normal of the plane below which nothing is lit: ng, or ns where
                         ///< light leaves from the smooth surface
    glm::dvec3 toSmooth; ///< from `position` to the origin of rays on the ray's side, or 0
    glm::dvec2 uv;
    glm::dvec3 dpdu; ///< partial derivative of the position; zero if there is none
    glm::dvec3 dpdv; ///< likewise
    uint32_t material;
    uint32_t primitive;
};

/// Moves the point `from` of a surface along `normalOnThatSide` (unit length), by 32 units in the
/// last place of its largest coordinate; its own rounding is half a unit, and that of the sum
/// another half.
glm::dvec3 offsetFrom(const glm::dvec3& from, const glm::dvec3& normalOnThatSide);

/// The point moved off the surface, to the side that `w` points to.
glm::dvec3 leaveSurface(const Surface& surface, const glm::dvec3& w);

} // namespace calotype::reference
