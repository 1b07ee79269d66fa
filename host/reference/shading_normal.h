#pragma once

#include <glm/vec3.hpp>

namespace calotype::reference {

/// The unit normal that the RGB `texel` of an OpenGL (+Y up) normal map asks for on a surface with
/// the unit normals n (shading) and ng: 2 c - 1 in the frame of the tangent along `dpdu`, the
/// bitangent on the side of `dpdv`, and n. Mirrored at the true surface where it leans below it; n
/// where there is no tangent.
glm::dvec3 mappedNormal(const glm::dvec3& texel, const glm::dvec3& n, const glm::dvec3& dpdu,
                        const glm::dvec3& dpdv, const glm::dvec3& ng);

/// The unit shading normal, bent as far as it takes for the mirrored viewer to stand above the true
/// surface: at least a fiftieth of the viewer's own height (Keller et al. 2017, "The Iray Light
/// Transport Simulation and Rendering System", section A.3). wo and ns lie on the side of ng.
glm::dvec3 consistentNormal(const glm::dvec3& wo, const glm::dvec3& ng, const glm::dvec3& ns);

/// w, mirrored at the plane of the normal if it lies below.
glm::dvec3 ontoSideOf(const glm::dvec3& normal, const glm::dvec3& w);

} // namespace calotype::reference
