// The types of shared structs, with the same names in C++ and GLSL.
#ifndef CALOTYPE_SHARED_TYPES_H
#define CALOTYPE_SHARED_TYPES_H

#ifdef __cplusplus
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace calotype::shared {
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = uint32_t;
} // namespace calotype::shared

#define CALOTYPE_BEGIN_SHARED namespace calotype::shared {
#define CALOTYPE_END_SHARED }
#define CALOTYPE_CONSTANT inline constexpr
#define CALOTYPE_FUNCTION constexpr
#else
#define CALOTYPE_BEGIN_SHARED
#define CALOTYPE_END_SHARED
#define CALOTYPE_CONSTANT const
#define CALOTYPE_FUNCTION
#endif

#endif
