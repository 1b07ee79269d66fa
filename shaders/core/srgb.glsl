// From sRGB-encoded to linear values.
#ifndef CALOTYPE_CORE_SRGB_GLSL
#define CALOTYPE_CORE_SRGB_GLSL

/// IEC 61966-2-1 for a value in [0, 1]. x to the power 2.4 is x times a polynomial in sqrt(x),
/// fitted to the range in use (minimax in the relative error): within 1.2e-6 of the value. GLSL's
/// pow is less accurate and slower.
float linearFromSrgb(float encoded) {
    float x = (encoded + 0.055) * (1.0 / 1.055);
    float s = sqrt(x);
    float power =
        x * (5.577888902022762e-4 +
             s * (-1.0173687495346778e-2 +
                  s * (1.0859484422924566e-1 +
                       s * (1.0664659434054675 +
                            s * (-2.381491696579545e-1 +
                                 s * (9.008948095977468e-2 + s * -1.738576617620589e-2))))));
    return encoded <= 0.04045 ? encoded * (1.0 / 12.92) : power;
}

vec3 linearFromSrgb(vec3 encoded) {
    return vec3(linearFromSrgb(encoded.x), linearFromSrgb(encoded.y), linearFromSrgb(encoded.z));
}

#endif
