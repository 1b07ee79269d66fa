// How much of the light a smooth boundary reflects.
#ifndef CALOTYPE_BSDF_FRESNEL_GLSL
#define CALOTYPE_BSDF_FRESNEL_GLSL

/// Schlick's approximation (docs/models.md, "Fresnel, Schlick") for the cosine between direction
/// and normal, in [0, 1].
vec3 fresnelSchlick(vec3 f0, float cosTheta) {
    float m = 1.0 - min(cosTheta, 1.0);
    float m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}

struct Refraction {
    float reflectance; ///< of unpolarised light; 1 under total internal reflection
    float cosThetaT;   ///< of the refracted direction; 0 under total internal reflection
};

/// Snell's law and the exact Fresnel equations (docs/models.md, "Fresnel, exact"); `w` is a unit
/// direction in the boundary's frame. `eta` is the index of refraction beyond the boundary over
/// that on the side of w. cos^2 of the refracted angle is 1 - sin^2 / eta^2, which is off by no
/// more than sin^2 of that angle is, a few roundings. About eta = 1 that is too much where the
/// light grazes: there it is (eta^2 - 1 + cos^2) / eta^2, which cancels for small eta in its turn.
Refraction refractDielectric(vec3 w, float eta) {
    float cosThetaI = w.z;
    float eta2 = eta * eta;
    float cos2ThetaT = eta2 < 0.5 ? 1.0 - dot(w.xy, w.xy) / eta2
                                  : ((eta - 1.0) * (eta + 1.0) + cosThetaI * cosThetaI) / eta2;
    if (cos2ThetaT <= 0.0)
        return Refraction(1.0, 0.0);
    float cosThetaT = sqrt(cos2ThetaT);
    float parallel = (eta * cosThetaI - cosThetaT) / (eta * cosThetaI + cosThetaT);
    float perpendicular = (cosThetaI - eta * cosThetaT) / (cosThetaI + eta * cosThetaT);
    float reflectance = 0.5 * (parallel * parallel + perpendicular * perpendicular);
    return Refraction(reflectance, cosThetaT);
}

#endif
