#include "reference/shading_normal.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace calotype::reference {

glm::dvec3 ontoSideOf(const glm::dvec3& normal, const glm::dvec3& w) {
    return w - std::min(2.0 * glm::dot(w, normal), 0.0) * normal;
}

glm::dvec3 mappedNormal(const glm::dvec3& texel, const glm::dvec3& n, const glm::dvec3& dpdu,
                        const glm::dvec3& dpdv, const glm::dvec3& ng) {
    const glm::dvec3 alongU = dpdu - glm::dot(dpdu, n) * n;
    if (alongU == glm::dvec3(0.0))
        return n;
    const glm::dvec3 tangent = glm::normalize(alongU);
    const glm::dvec3 cross = glm::cross(n, tangent);
    const glm::dvec3 bitangent = glm::dot(cross, dpdv) < 0.0 ? -cross : cross;
    const glm::dvec3 slope = 2.0 * texel - 1.0;
    const glm::dvec3 mapped = ontoSideOf(ng, slope.x * tangent + slope.y * bitangent + slope.z * n);
    return mapped == glm::dvec3(0.0) ? n : glm::normalize(mapped);
}

glm::dvec3 consistentNormal(const glm::dvec3& wo, const glm::dvec3& ng, const glm::dvec3& ns) {
    constexpr double kLeastShare = 0.02;   // of the viewer's cosine to ng
    constexpr double kLeastCosine = 1e-6;  // above the device's rounding of a cosine
    constexpr double kLeastLength2 = 1e-4; // remainder of a direction straight down, squared
    const glm::dvec3 mirrored = glm::reflect(-wo, ns);
    const double height = glm::dot(mirrored, ng);
    double lowest = std::max(kLeastShare * glm::dot(wo, ng), kLeastCosine);
    if (height >= lowest)
        return ns;
    lowest = std::max(lowest, std::sqrt(std::max(height * height - 1.0 + kLeastLength2, 0.0)));
    return glm::normalize(wo + glm::normalize(mirrored + (lowest - height) * ng));
}

} // namespace calotype::reference
