#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/lobe.h"
#include "reference/surface.h"
#include "scene/scene.h"

namespace calotype::reference {

/// A material at a point of a surface, its textures looked up, seen from one direction: a mixture
/// of lobes. Directions are unit vectors in the world, away from the surface; densities are per
/// solid angle.
class Bsdf {
public:
    struct Value {
        glm::dvec3 value{0.0}; ///< f |cos|
        double pdf = 0.0;      ///< of the mixture of all lobes that have a density
    };

    struct Sample {
        glm::dvec3 wi{0.0};
        glm::dvec3 weight{0.0}; ///< f |cos| / pdf; zero where nothing is scattered
        double pdf = 0.0;       ///< infinite for a specular direction
        bool crosses = false;   ///< wi goes to the far side
        double eta = 1.0;       ///< index of refraction on wi's side over that on the viewer's
    };

    Bsdf(const Material& material, const std::vector<Texture>& textures, const Surface& surface,
         const glm::dvec3& wo);

    /// The geometric normal on the viewer's side.
    const glm::dvec3& ng() const { return ng_; }

    /// True where light comes from certain directions only.
    bool isSpecular() const;

    /// True where light samples from the far side count: some lobe has a density there.
    bool transmits() const;

    /// Specular light has no value at any direction.
    Value evaluate(const glm::dvec3& wi) const;

    /// u.x and u.y pick within a lobe, u.z the lobe; each in [0, 1).
    Sample sample(const glm::dvec3& u) const;

private:
    struct WeightedLobe {
        std::unique_ptr<Lobe> lobe;
        double start = 0.0; ///< of the random numbers that choose the lobe
        double end = 0.0;

        double chance() const { return end - start; }
    };

    template <typename Kind, typename... Arguments>
    void add(Arguments&&... arguments) {
        lobes_.push_back({std::make_unique<Kind>(std::forward<Arguments>(arguments)...)});
    }

    void addLobes(const Material& material, const std::vector<Texture>& textures,
                  const glm::dvec2& uv, bool isOutside);
    void shareOut();
    bool isScattered(const glm::dvec3& wi, const glm::dvec3& wiWorld) const;

    std::vector<WeightedLobe> lobes_;
    glm::dvec3 ng_;
    glm::dvec3 horizon_; ///< on the viewer's side; nothing is lit from below its plane
    glm::dmat3 worldFromShading_;
    glm::dvec3 wo_; ///< in the shading frame
};

/// The colour of a material at texture coordinates, textures included.
glm::dvec3 colorAt(const Material& material, const std::vector<Texture>& textures,
                   const glm::dvec2& uv);

/// The share of light that meets the surface there, in [0, 1]; the rest passes through.
double alphaAt(const Material& material, const std::vector<Texture>& textures,
               const glm::dvec2& uv);

/// The unit shading normal with the material's normal map, on the side of ng.
glm::dvec3 shadingNormal(const Material& material, const std::vector<Texture>& textures,
                         const Surface& surface);

} // namespace calotype::reference
