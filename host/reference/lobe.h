#pragma once

#include <glm/vec3.hpp>

namespace calotype::reference {

/// One way in which a surface scatters light. Directions are unit vectors in the shading frame,
/// away from the surface: z is the shading normal, on the viewer's side. wo.z > 0; wi may lie on
/// either side. wi.z > 0 is a reflection, wi.z < 0 a transmission.
class Lobe {
public:
    struct Sample {
        glm::dvec3 wi;
        bool isSpecular = false;        ///< a discrete direction, without a density
        glm::dvec3 specularWeight{0.0}; ///< f |cos| / pdf of a specular direction
        double eta = 1.0; ///< index of refraction on wi's side over that on the viewer's
    };

    virtual ~Lobe() = default;

    /// True if the lobe scatters to certain directions only: f and pdf are zero.
    virtual bool isSpecular() const { return false; }

    /// True if the lobe has a density on the far side.
    virtual bool transmits() const { return false; }

    /// Roughly the share of white light that the lobe scatters, at least 0. The lobes of a material
    /// are sampled with probabilities in proportion to it.
    virtual double albedo(const glm::dvec3& wo) const = 0;

    /// The BSDF in 1/sr, without the cosine. Zero in directions without scattering.
    virtual glm::dvec3 f(const glm::dvec3& wo, const glm::dvec3& wi) const = 0;

    /// The density of wi, per solid angle, with which `sample` draws it.
    virtual double pdf(const glm::dvec3& wo, const glm::dvec3& wi) const = 0;

    /// Each component of u is in [0, 1).
    virtual Sample sample(const glm::dvec3& wo, const glm::dvec3& u) const = 0;
};

} // namespace calotype::reference
