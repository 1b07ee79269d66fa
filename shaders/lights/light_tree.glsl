// Chooses a light of many by what it may contribute to a point, through a binary tree of clusters
// (docs/models.md, "Light tree"; Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights
// with Adaptive Tree Splitting").
//
// The random numbers that choose a cluster are an interval, whose length is divided among the
// cluster's children in proportion to their importances. So a light's probability is the length of
// its interval. Both functions that go down the tree do the same operations, so that they agree to
// the last bit. Each takes a pass of a loop for each node: kernels count them (passesOfChoice),
// since llvmpipe ends the loops of a kernel after 65,535 passes.
//
// The loops have their test at the top. With a test at the bottom, llvmpipe (Mesa 22.3) gives lanes
// that have left the loop values from later passes (tests/gpu/light_tree_test.cpp fails).
#ifndef CALOTYPE_LIGHTS_LIGHT_TREE_GLSL
#define CALOTYPE_LIGHTS_LIGHT_TREE_GLSL

#include "bsdf/lobes.glsl"
#include "buffers/packed_scene.glsl"
#include "core/constants.glsl"
#include "core/random.glsl"

/// What is known of some lights: a sphere that contains them, and a cone that contains the normals
/// of their lit sides or, if they are two-sided, these or their opposites.
struct ClusterOfLights {
    vec3 center;
    float radius;
    vec3 axis;
    float cosThetaO;
    bool isTwoSided;
};

/// A point to be lit. Light is scattered there only from the side of the normal or, if the kernel
/// has surfaces that transmit, from all directions.
struct LitPoint {
    vec3 position;
    vec3 normal; ///< unit
};

/// More than the rounding error of the cosines, so that no light that just shines has none.
const float kCosineError = 1.0 / 512.0;

float sinOfCos(float cosine) { return sqrt(max(1.0 - cosine * cosine, 0.0)); }

/// A bound of the cosine between the normal of a light of the cluster and the direction from it to
/// a point outside of the sphere. `toPoint` is the unit vector from the centre, and sinThetaU the
/// sine of the angle that the sphere subtends. 0 if no light may shine there.
float emittedShare(ClusterOfLights cluster, vec3 toPoint, float sinThetaU) {
    float along = dot(cluster.axis, toPoint);
    float cosTheta = clamp(cluster.isTwoSided ? abs(along) : along, -1.0, 1.0);
    float cosOutside =
        cosTheta >= cluster.cosThetaO
            ? 1.0
            : cosTheta * cluster.cosThetaO + sinOfCos(cosTheta) * sinOfCos(cluster.cosThetaO);
    return clamp(cosOutside + sinThetaU + kCosineError, 0.0, 1.0);
}

/// Likewise of the cosine between the normal of the lit point and the direction to a light.
float receivedShare(vec3 normal, vec3 toPoint, float sinThetaU) {
    return clamp(sinThetaU + kCosineError - dot(normal, toPoint), 0.0, 1.0);
}

/// The importance of a cluster for a point is emitted / distance2, up to the cluster's power, or
/// that times `received`. The squared distance is from the centre, and counts as the radius inside
/// the sphere.
struct Importance {
    float emitted;
    float received;
    float distance2; ///< m^2, above 0
};

Importance importanceOf(ClusterOfLights cluster, LitPoint p) {
    vec3 d = p.position - cluster.center;
    float distance2 = dot(d, d);
    float radius2 = cluster.radius * cluster.radius;
    if (distance2 <= radius2)
        return Importance(1.0, 1.0, radius2);
    float inverseDistance = inversesqrt(distance2);
    vec3 toPoint = d * inverseDistance;
    float sinThetaU = cluster.radius * inverseDistance;
    return Importance(emittedShare(cluster, toPoint, sinThetaU),
                      hasTransmission ? 1.0 : receivedShare(p.normal, toPoint, sinThetaU),
                      distance2);
}

/// The shares of a node's first child among the lights of the node: of those that are chosen for a
/// point, and of those that would be without its normal. If no light of the node shines there, the
/// share is any: what is chosen is dark.
struct SharesOfFirst {
    float chosen;
    float withoutNormal;
};

/// Below 1 where the other can be chosen, also if it is so little that the quotient rounds to 1.
float shareOf(float weight, float other) {
    float sum = weight + other;
    float share = sum > 0.0 ? weight / sum : 0.5;
    return other > 0.0 ? min(share, kOneMinusEpsilon) : share;
}

SharesOfFirst sharesOfFirst(LightNode node, LitPoint p) {
    ClusterOfLights first = ClusterOfLights(node.center0, node.radius0, node.axis0, node.cosThetaO0,
                                            (node.child0 & kChildIsTwoSided) != 0u);
    ClusterOfLights second =
        ClusterOfLights(node.center1, node.radius1, node.axis1, node.cosThetaO1,
                        (node.child1 & kChildIsTwoSided) != 0u);
    Importance importance0 = importanceOf(first, p);
    Importance importance1 = importanceOf(second, p);
    float weight0 = node.power0 * importance0.emitted * importance1.distance2;
    float weight1 = node.power1 * importance1.emitted * importance0.distance2;
    return SharesOfFirst(shareOf(weight0 * importance0.received, weight1 * importance1.received),
                         shareOf(weight0, weight1));
}

bool isLightChild(uint child) { return (child & kChildIsLight) != 0u; }

uint indexOfChild(uint child) { return child & ~(kChildIsLight | kChildIsTwoSided); }

/// A number in an interval, both in units of 2^-24: the number is place + fraction.
struct PlaceInInterval {
    uint place;
    float fraction; ///< in [0, 1]
    float size;     ///< of the interval
};

/// Whether the number is in the first `size` of its interval, to which the interval is reduced;
/// otherwise it is reduced to the rest.
bool takesFirst(inout PlaceInInterval number, float size) {
    uint whole = uint(size);
    float part = size - float(whole);
    bool isFirst = number.place < whole || (number.place == whole && number.fraction < part);
    if (isFirst) {
        number.size = size;
    } else {
        bool borrows = number.fraction < part;
        number.place -= whole + (borrows ? 1u : 0u);
        number.fraction += (borrows ? 1.0 : 0.0) - part;
        number.size -= size;
    }
    return isFirst;
}

/// Goes down to a light. Returns its index, and leaves in `number` the light's interval. Multiplies
/// `sizeWithoutNormal` by the light's probability without the normal.
uint chooseInTree(LitPoint p, inout PlaceInInterval number, inout float sizeWithoutNormal) {
    uint child = 0u;
    while (!isLightChild(child)) {
        LightNode node = loadLightNode(indexOfChild(child));
        SharesOfFirst shares = sharesOfFirst(node, p);
        bool isFirst = takesFirst(number, shares.chosen * number.size);
        float ofFirst = shares.withoutNormal * sizeWithoutNormal;
        sizeWithoutNormal = isFirst ? ofFirst : sizeWithoutNormal - ofFirst;
        child = isFirst ? node.child0 : node.child1;
    }
    return indexOfChild(child);
}

/// The size of a light's interval for a point without a normal, of an interval of that size for the
/// whole tree.
float sizeInTree(uint trail, vec3 position, float size) {
    LitPoint p = LitPoint(position, vec3(0.0));
    uint child = 0u;
    while (!isLightChild(child)) {
        LightNode node = loadLightNode(indexOfChild(child));
        float ofFirst = sharesOfFirst(node, p).withoutNormal * size;
        bool isFirst = (trail & 1u) == 0u;
        size = isFirst ? ofFirst : size - ofFirst;
        child = isFirst ? node.child0 : node.child1;
        trail >>= 1u;
    }
    return size;
}

#endif
