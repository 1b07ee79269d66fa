#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace calotype::reference {

inline glm::dvec3 halfVector(const glm::dvec3& wo, const glm::dvec3& wi) {
    return glm::normalize(wo + wi);
}

} // namespace calotype::reference
