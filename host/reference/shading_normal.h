#pragma once

#include <glm/vec3.hpp>

namespace calotype::reference {

/// The unit normal that the RGB `texel` of an OpenGL (+Y up) normal map stands for on a surface
/// with the unit normals n (shading) and ng: 2 c - 1 in the frame of the tangent along `dpdu`, the
/// bitangent on the side of `dpdv`, and n. If it points below the true surface, it is mirrored
/// there; n if there is no tangent.
glm::dvec3 mappedNormal(const glm::dvec3& texel, const glm::dvec3& n, const glm::dvec3& dpdu,
                        const glm::dvec3& dpdv, const glm::dvec3& ng);

/// The unit shading normal, bent as far as needed for the reflected view direction to be above the
/// true surface: its height is at least a fiftieth of the viewer's (Keller et al. 2017, "The Iray
/// Light Transport Simulation and Rendering System", section A.3). wo and ns are on the side of ng.
glm::dvec3 consistentNormal(const glm::dvec3& wo, const glm::dvec3& ng, const glm::dvec3& ns);

/// w, mirrored at the plane of the normal if it is below.
glm::dvec3 ontoSideOf(const glm::dvec3& normal, const glm::dvec3& w);

} // namespace calotype::reference
