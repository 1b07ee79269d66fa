// The half vector of a reflection.
#ifndef CALOTYPE_BSDF_HALF_VECTOR_GLSL
#define CALOTYPE_BSDF_HALF_VECTOR_GLSL

struct HalfVector {
    vec3 h;          ///< unit
    float cosThetaD; ///< of the angle between h and either direction
};

/// wo.h is computed as half of |wo + wi|: if both directions are at grazing angles on opposite
/// sides, the sign of the dot product is noise.
HalfVector halfVectorOf(vec3 wo, vec3 wi) {
    vec3 sum = wo + wi;
    return HalfVector(normalize(sum), 0.5 * length(sum));
}

/// wo reflected at the unit half vector h.
vec3 mirroredAt(vec3 h, vec3 wo) { return 2.0 * dot(wo, h) * h - wo; }

#endif
