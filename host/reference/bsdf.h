#pragma once

#include <memory>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/lobe.h"
#include "reference/surface.h"
#include "scene/scene.h"

namespace calotype::reference {

using Lobes = std::vector<std::unique_ptr<Lobe>>;

/// Returns the lobes of a material at texture coordinates. `isOutside`: the viewer is on the outer
/// side of the surface.
using LobesOf = Lobes (*)(const Material& material, const std::vector<Texture>& textures,
                          const glm::dvec2& uv, bool isOutside);

/// The lobes of the program's materials.
Lobes lobesOfMaterial(const Material& material, const std::vector<Texture>& textures,
                      const glm::dvec2& uv, bool isOutside);

/// A material at a point of a surface, with its textures looked up, seen from one direction: a
/// mixture of lobes. Directions are unit vectors in world space, away from the surface; densities
/// are per solid angle.
class Bsdf {
public:
    struct Value {
        glm::dvec3 value{0.0}; ///< f |cos|
        double pdf = 0.0;      ///< of the mixture of all lobes that have a density
    };

    struct Sample {
        glm::dvec3 wi{0.0};
        glm::dvec3 weight{0.0}; ///< f |cos| / pdf; zero if nothing is scattered
        double pdf = 0.0;       ///< infinite for a specular direction
        bool crosses = false;   ///< wi is on the far side
        double eta = 1.0;       ///< index of refraction on wi's side over that on the viewer's
    };

    Bsdf(const Material& material, const std::vector<Texture>& textures, const Surface& surface,
         const glm::dvec3& wo, LobesOf lobesOf = lobesOfMaterial);

    /// The geometric normal on the viewer's side.
    const glm::dvec3& ng() const { return ng_; }

    /// The shading normal, bent where needed: no light is reflected from below its plane.
    const glm::dvec3& ns() const { return worldFromShading_[2]; }

    /// True if light is scattered to certain directions only.
    bool isSpecular() const;

    /// True if light is also sampled from the far side: some lobe has a density there.
    bool transmits() const;

    /// Specular light has no value in any direction.
    Value evaluate(const glm::dvec3& wi) const;

    /// u.z chooses the lobe, u.x and u.y the direction; each in [0, 1).
    Sample sample(const glm::dvec3& u) const;

private:
    struct WeightedLobe {
        std::unique_ptr<Lobe> lobe;
        double start = 0.0; ///< of the random numbers that choose this lobe
        double end = 0.0;

        double chance() const { return end - start; }
    };

    void shareOut();
    bool isScattered(const glm::dvec3& wi, const glm::dvec3& wiWorld) const;

    std::vector<WeightedLobe> lobes_;
    glm::dvec3 ng_;
    glm::dvec3 horizon_; ///< on the viewer's side; no light comes from below its plane
    glm::dmat3 worldFromShading_;
    glm::dvec3 wo_; ///< in the shading frame
};

/// The colour of a material at texture coordinates, textures included.
glm::dvec3 colorAt(const Material& material, const std::vector<Texture>& textures,
                   const glm::dvec2& uv);

/// The share of light that the surface scatters there, in [0, 1]; the rest passes through.
double alphaAt(const Material& material, const std::vector<Texture>& textures,
               const glm::dvec2& uv);

/// The unit shading normal after the material's normal map, on the side of ng.
glm::dvec3 shadingNormal(const Material& material, const std::vector<Texture>& textures,
                         const Surface& surface);

} // namespace calotype::reference
