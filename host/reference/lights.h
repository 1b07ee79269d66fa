#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/geometry.h"
#include "scene/scene.h"

namespace calotype::reference {

/// A primitive that shines, or the background.
struct Light {
    std::optional<uint32_t> primitive; ///< none for the background
    glm::dvec3 radiance{0.0};
    double area = 0.0;                 ///< m^2
    double selectionProbability = 0.0; ///< with which it is chosen; 1 where all are
    bool shinesFromBack = false;
    bool isHiddenFromCamera = false;

    /// Radiance that leaves in direction `w` a point whose front has this normal.
    glm::dvec3 emitted(const glm::dvec3& normal, const glm::dvec3& w) const;
};

/// A direction in which light may come to a reference point.
struct LightSample {
    glm::dvec3 position{0.0}; ///< on the light; of the background, a direction
    glm::dvec3 normal{0.0};   ///< of the front there
    double pdf = 0.0;         ///< per solid angle at the reference point; 0 where it is not seen
};

/// All lights of a scene: in the order of their primitives, the background last.
class Lights {
public:
    Lights(const Scene& scene, const Geometry& geometry);

    bool empty() const { return lights_.empty(); }
    const std::vector<Light>& all() const { return lights_; }

    /// Of any channel, W/(m^2 sr); 0 without lights.
    double maxRadiance() const;

    /// The light that a primitive is; nullptr for one that does not shine.
    const Light* ofPrimitive(uint32_t primitive) const;

    /// nullptr without a background.
    const Light* background() const;

    struct Choice {
        const Light& light;
        double u; ///< in [0, 1): where among the random numbers that choose the light there
    };

    /// Chosen by power, by a column of an alias table (Walker 1974, Vose 1991). u.x, a multiple of
    /// 2^-24, chooses; u.y picks between that number and the next.
    Choice choose(const glm::dvec2& u) const;

    LightSample sample(const Light& light, const glm::dvec3& reference, const glm::dvec2& u) const;

    /// The density with which `sample` chooses a point of a light that is a primitive.
    double pdf(const Light& light, const glm::dvec3& reference, const glm::dvec3& position,
               const glm::dvec3& normal) const;

private:
    /// Of the alias table: random numbers, in units of 2^-24, from `first` up to but not including
    /// `end`. Those from `aliasFrom` on choose the alias.
    struct Column {
        uint64_t first = 0;
        uint64_t aliasFrom = 0;
        uint64_t end = 0;
        size_t alias = 0;
    };

    void add(uint32_t primitive, const Material& material);
    void addBackground();
    void buildAliasTable();
    std::vector<uint64_t> dealNumbers() const;
    const Shape& shapeOf(const Light& light) const;

    const Scene& scene_;
    const Geometry& geometry_;
    std::vector<Light> lights_;
    std::vector<double> powers_;        ///< of each light, up to a common factor
    std::vector<uint32_t> ofPrimitive_; ///< index into lights_, or kNone
    std::vector<Column> columns_;
    static constexpr uint32_t kNone = ~0u;
};

} // namespace calotype::reference
