#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "reference/geometry.h"
#include "reference/light.h"
#include "reference/tree_choice.h"
#include "scene/scene.h"
#include "settings/light_choice.h"

namespace calotype::reference {

/// All lights of a scene, and the choice of one.
class Lights {
public:
    Lights(const Scene& scene, const Geometry& geometry, LightChoice choice = LightChoice::Power);

    bool empty() const { return lights_.empty(); }
    const std::vector<std::unique_ptr<Light>>& all() const { return lights_; }

    /// The largest radiance of any channel, W/(m^2 sr); 0 without lights.
    double maxRadiance() const;

    /// The light of a primitive; nullptr if it does not emit.
    const Light* ofPrimitive(uint32_t primitive) const { return ofPrimitive_[primitive]; }

    /// The light for rays that hit no surface; nullptr if there is none.
    const Light* infinite() const { return infinite_; }

    struct Choice {
        const Light& light;
        double u; ///< uniform in [0, 1), also given that this light was chosen
        double probability;
        double probabilityForMis; ///< probability(light) at the same point
    };

    /// Chooses a light to illuminate that point. u.x, a multiple of 2^-24, chooses; u.y
    /// interpolates between that number and the next.
    Choice choose(const LitPoint& point, const glm::dvec2& u) const;

    /// The probability with which `choose` would choose that light if it did not know the normal of
    /// the point; 1 if all lights are sampled.
    double probability(const Light& light, const glm::dvec3& shadingPoint) const;

private:
    /// A column of the alias table: random numbers, in units of 2^-24, from `first` up to but not
    /// including `end`. Those from `aliasFrom` on choose the alias.
    struct Column {
        uint64_t first = 0;
        uint64_t aliasFrom = 0;
        uint64_t end = 0;
        size_t alias = 0;
    };

    void add(uint32_t primitive, const Material& material);
    void addBackground();
    void buildAliasTable(LightChoice choice);
    void buildTree();
    Choice chooseInTable(const glm::dvec2& u) const;
    bool isInTree(const Light& light) const { return !tree_.empty() && &light != infinite_; }
    std::vector<uint64_t> dealNumbers() const;

    const Scene& scene_;
    const Geometry& geometry_;
    std::vector<std::unique_ptr<Light>> lights_;
    std::vector<double> powers_;            ///< of each light, up to a common factor
    std::vector<const Light*> ofPrimitive_; ///< nullptr if the primitive does not emit
    const Light* infinite_ = nullptr;
    std::vector<Column> columns_;
    TreeChoice tree_;                       ///< empty if the table chooses
    std::vector<uint32_t> primitiveOfTree_; ///< the primitives of the tree's lights
    std::vector<uint32_t> inTree_;          ///< by primitive: its light in the tree
};

} // namespace calotype::reference
