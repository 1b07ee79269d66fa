#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace calotype::test {

/// The reflection models of docs/models.md, written once more, in double precision and in their
/// simplest form. Directions are unit vectors in the shading frame, whose z is the normal on the
/// viewer's side; wo.z > 0 and wi.z > 0. Not for dielectrics.
glm::dvec3 oracleValue(const Material& material, const glm::dvec3& wo, const glm::dvec3& wi);

/// Density per solid angle of the material's half-vector lobe: visible normals for GGX (Heitz
/// 2018), (n + 1) / (2 pi) cosH^n for Blinn-Phong; both with the Jacobian 1 / (4 wo.h).
double oracleHalfVectorPdf(const Material& material, const glm::dvec3& wo, const glm::dvec3& wi);

/// Share of unpolarised light that a smooth boundary reflects; `eta` is the index beyond it over
/// the index on the side of the light. From the sines and tangents of Fresnel's own form.
double oracleFresnel(double cosThetaI, double eta);

} // namespace calotype::test
