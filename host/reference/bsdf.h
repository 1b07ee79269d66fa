#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "reference/lobes.h"
#include "reference/surface.h"
#include "scene/scene.h"

namespace calotype::reference {

/// A material at a point of a surface, its textures looked up, seen from one direction. Directions
/// are unit vectors in the world, away from the surface; densities are per solid angle.
class Bsdf {
public:
    struct Value {
        glm::dvec3 value{0.0}; ///< f |cos|
        double pdf = 0.0;      ///< of the mixture of all lobes that have a density
    };

    struct Sample {
        glm::dvec3 wi{0.0};
        glm::dvec3 weight{0.0}; ///< f |cos| / pdf; zero where nothing is scattered
        double pdf = 0.0;       ///< infinite for a direction that is certain
        bool crosses = false;   ///< wi goes to the far side
    };

    /// Below this alpha (no unit: the tangent of a lobe's half width), GGX is a mirror: the
    /// threshold that the README documents.
    static constexpr double kMirrorAlpha = 1e-4;

    Bsdf(const Material& material, const std::vector<Texture>& textures, const Surface& surface,
         const glm::dvec3& wo);

    /// The geometric normal on the viewer's side.
    const glm::dvec3& ng() const { return ng_; }

    /// Of a dielectric: index of refraction on the far side over that on the viewer's.
    double eta() const { return eta_; }

    /// True where light comes from one or two certain directions only.
    bool isSpecular() const;

    /// Specular light has no value at any direction.
    Value evaluate(const glm::dvec3& wi) const;

    /// u.x and u.y pick within a lobe, u.z the lobe; each in [0, 1).
    Sample sample(const glm::dvec3& u) const;

private:
    bool isMirror() const { return hasGgx_ && ggx_.alpha() < kMirrorAlpha; }
    glm::dvec3 toWorld(const glm::dvec3& w) const { return worldFromShading_ * w; }
    Sample sampleDielectric(double u) const;

    bool isDielectric_ = false;
    bool hasGgx_ = false;
    bool hasBlinnPhong_ = false;
    glm::dvec3 diffuse_{0.0}; ///< reflectance of the diffuse lobe
    double diffuseProbability_ = 1.0;
    Ggx ggx_;
    BlinnPhong blinnPhong_;
    glm::dvec3 tint_{1.0};
    double eta_ = 1.0; ///< of the far side over the viewer's
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
