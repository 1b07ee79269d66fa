#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace calotype::reference {

/// A light source. Directions `wi` are unit vectors from a shading point to the light; radiances
/// are in W/(m^2 sr).
class Light {
public:
    /// A point on the light, and the unit normal of its front. Not used if the light is infinitely
    /// far away.
    struct Point {
        glm::dvec3 position{0.0};
        glm::dvec3 normal{0.0};
    };

    /// A sampled direction from a shading point to the light.
    struct Sample {
        glm::dvec3 wi{0.0};
        Point point;
        double pdf = 0.0; ///< per solid angle at the shading point; 0 if not visible from there
    };

    explicit Light(std::optional<uint32_t> primitive = {}) : primitive_(primitive) {}
    virtual ~Light() = default;

    /// None for a light that is infinitely far away.
    std::optional<uint32_t> primitive() const { return primitive_; }

    /// u in [0, 1)^2.
    virtual Sample sample(const glm::dvec3& shadingPoint, const glm::dvec2& u) const = 0;

    /// The density with which `sample` chooses the point of the light in direction wi.
    virtual double pdf(const glm::dvec3& shadingPoint, const glm::dvec3& wi,
                       const Point& point) const = 0;

    /// The radiance that arrives from `point` if nothing blocks it.
    virtual glm::dvec3 radiance(const glm::dvec3& wi, const Point& point) const = 0;

    /// The largest radiance of any channel, point and direction.
    virtual double maxRadiance() const = 0;

    virtual bool isHiddenFromCamera() const { return false; }

    double selectionProbability = 0.0; ///< of choosing this light; 1 if all lights are sampled

private:
    std::optional<uint32_t> primitive_;
};

} // namespace calotype::reference
