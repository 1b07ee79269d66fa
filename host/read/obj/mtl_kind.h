#pragma once

#include <functional>
#include <initializer_list>

#include <glm/vec3.hpp>

#include "read/obj/mtl_file.h"

namespace calotype {

/// The grey of faces whose MTL file gives no colour.
constexpr double kUnstatedColor = 0.5;
/// From this metallic share on (Pm), a material is a metal.
constexpr double kMetallic = 0.5;
/// Above this weight (MtlMaterial::transmission), a material is glass.
constexpr double kTransmissive = 0.5;

/// What the statements of an MTL material say of its type and its images, without reading these.
/// Statements of Blender must have the meaning of others (see inBlendersMeaning).
class MtlKind {
public:
    explicit MtlKind(const MtlMaterial& mtl);

    bool isIllumination(std::initializer_list<int> models) const;

    /// Whether it transmits light. It is glass unless it is a metal, shines or has holes.
    bool isTransmissive() const;
    /// Whether it is a mirror, unless it is a metal or glass.
    bool isMirror() const;

    /// Ke, or what stands for it where only map_Ke is given.
    glm::dvec3 emission() const;
    /// Tf; 1 if it is not given.
    glm::dvec3 filter() const { return mtl_.filter.value_or(glm::dvec3(1.0)); }

    using VisitImage = std::function<void(const MtlTexture& map, bool isUploaded)>;
    /// Visits the maps of which it is sure that the material's type uses them. `isUploaded` is
    /// false for those of which the host alone is sure to need the image.
    void visitImages(const VisitImage& visit) const;

private:
    bool isBlack() const;
    bool isTinted() const;

    const MtlMaterial& mtl_;
    int illumination_;
};

} // namespace calotype
