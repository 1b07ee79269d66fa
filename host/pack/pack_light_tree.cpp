#include "pack/pack_light_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "math/greatest.h"
#include "math/outward_rounding.h"
#include "scene/light_tree.h"
#include "shared/specialization.h"

namespace calotype {
namespace {

/// The number of the light's primitive in the order of the scene file.
uint32_t idOf(const GpuScene& packed, const shared::Light& light) {
    if (light.primitive == shared::kNone)
        return shared::kNone;
    return (light.primitive & shared::kQuadricBit) != 0
               ? packed.quadrics[light.primitive & ~shared::kQuadricBit].id
               : packed.triangles[light.primitive].id;
}

/// The lights of primitives that are packed as lights.
struct TreeLights {
    std::vector<LightCluster> clusters;
    std::vector<uint32_t> packedIndices;
};

/// Both lists are in the order of the scene file.
TreeLights lightsForTree(const Scene& scene, const GpuScene& packed) {
    TreeLights lights;
    uint32_t light = 0;
    for (const PrimitiveLight& lit : primitiveLights(scene)) {
        while (light < packed.lightCount && idOf(packed, packed.lights[light]) < lit.primitive)
            ++light;
        if (light == packed.lightCount)
            break;
        if (idOf(packed, packed.lights[light]) == lit.primitive) {
            lights.clusters.push_back(lit.cluster);
            lights.packedIndices.push_back(light);
        }
    }
    return lights;
}

/// A cluster in the form of shared::LightNode.
struct PackedCluster {
    glm::vec3 center;
    float radius;
    glm::vec3 axis;
    float cosThetaO;
};

/// The sphere contains the cluster in spite of rounding: the kernels' coordinates are off by less
/// than 2^-21 of the distance from the origin. The cone is rounded to the nearest: the kernels
/// allow for more (kCosineError).
PackedCluster packCluster(const LightCluster& cluster, const glm::dvec3& origin) {
    constexpr double kPositionError = 0x1p-21;
    const auto center = glm::vec3(cluster.center() - origin);
    const glm::dvec3 middle(center);
    const glm::dvec3 reach = glm::max(glm::abs(cluster.bounds.lower - origin - middle),
                                      glm::abs(cluster.bounds.upper - origin - middle));
    const double radius = glm::length(reach);
    const double error = kPositionError * (greatest(glm::abs(middle)) + radius);
    return {center, roundUp(radius + error), glm::vec3(cluster.axis),
            static_cast<float>(std::cos(cluster.thetaO))};
}

/// A share above 0 stays above 0.
float packShare(double power, double sum) {
    return std::max(static_cast<float>(power / sum), std::numeric_limits<float>::min());
}

uint32_t packChild(const LightTree::Child& child, const std::vector<uint32_t>& packedIndices) {
    const uint32_t link =
        child.isLight ? packedIndices[child.index] | shared::kChildIsLight : child.index;
    return link | (child.cluster.isTwoSided ? shared::kChildIsTwoSided : 0);
}

shared::LightNode packLightNode(const LightTree::Node& node, const glm::dvec3& origin,
                                const std::vector<uint32_t>& packedIndices) {
    const auto& [first, second] = node.children;
    const PackedCluster packed0 = packCluster(first.cluster, origin);
    const PackedCluster packed1 = packCluster(second.cluster, origin);
    const double sum = first.cluster.power + second.cluster.power;
    shared::LightNode packed{};
    packed.center0 = packed0.center;
    packed.radius0 = packed0.radius;
    packed.axis0 = packed0.axis;
    packed.cosThetaO0 = packed0.cosThetaO;
    packed.center1 = packed1.center;
    packed.radius1 = packed1.radius;
    packed.axis1 = packed1.axis;
    packed.cosThetaO1 = packed1.cosThetaO;
    packed.power0 = packShare(first.cluster.power, sum);
    packed.power1 = packShare(second.cluster.power, sum);
    packed.child0 = packChild(first, packedIndices);
    packed.child1 = packChild(second, packedIndices);
    return packed;
}

} // namespace

void addLightTree(const Scene& scene, GpuScene& packed) {
    const TreeLights lights = lightsForTree(scene, packed);
    const LightTree tree = buildLightTree(lights.clusters);
    if (tree.nodes.empty())
        return;
    const float ofInfinite = packed.infiniteLight == shared::kNone
                                 ? 0.0f
                                 : packed.lights[packed.infiniteLight].selectionProbability;
    for (uint32_t i = 0; i < packed.lightCount; ++i)
        if (i != packed.infiniteLight)
            packed.lights[i].selectionProbability = 0.0f;
    for (size_t i = 0; i < lights.packedIndices.size(); ++i) {
        shared::Light& light = packed.lights[lights.packedIndices[i]];
        light.selectionProbability = 1.0f - ofInfinite; // exact: a multiple of 2^-24
        light.alias = tree.trails[i];
    }
    for (const LightTree::Node& node : tree.nodes)
        packed.lightNodes.push_back(packLightNode(node, packed.origin, lights.packedIndices));
    packed.lightTreeDepth = tree.depth;
    packed.features.enabled[shared::kFeatureLightTree] = true;
}

} // namespace calotype
