// Minimum and maximum as one comparison and one selection. GLSL's own also order NaN, which costs
// several instructions a component on CPUs; these return the second argument if either is NaN.
#ifndef CALOTYPE_CORE_SELECT_GLSL
#define CALOTYPE_CORE_SELECT_GLSL

float lesser(float a, float b) { return a < b ? a : b; }
float greater(float a, float b) { return a > b ? a : b; }

vec2 lesser(vec2 a, vec2 b) { return vec2(lesser(a.x, b.x), lesser(a.y, b.y)); }
vec2 greater(vec2 a, vec2 b) { return vec2(greater(a.x, b.x), greater(a.y, b.y)); }

vec3 lesser(vec3 a, vec3 b) { return vec3(lesser(a.x, b.x), lesser(a.y, b.y), lesser(a.z, b.z)); }
vec3 greater(vec3 a, vec3 b) {
    return vec3(greater(a.x, b.x), greater(a.y, b.y), greater(a.z, b.z));
}

vec4 lesser(vec4 a, vec4 b) { return vec4(lesser(a.xy, b.xy), lesser(a.zw, b.zw)); }
vec4 greater(vec4 a, vec4 b) { return vec4(greater(a.xy, b.xy), greater(a.zw, b.zw)); }

/// Of a vector's components.
float least(vec3 v) { return lesser(lesser(v.x, v.y), v.z); }
float greatest(vec3 v) { return greater(greater(v.x, v.y), v.z); }

#endif
