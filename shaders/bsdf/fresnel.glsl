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
/// vector in the boundary's frame. `eta` is the index of refraction beyond the boundary over that
/// on the side of w. cos^2 of the refracted angle is 1 - sin^2 / eta^2; its error is a few
/// roundings, like that of sin^2. For eta near 1 and grazing light this is too much: there the code
/// uses (eta^2 - 1 + cos^2) / eta^2, which in turn cancels for small eta.
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
