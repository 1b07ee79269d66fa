// Shading normals: from normal maps, and in agreement with the true surface.
#ifndef CALOTYPE_BSDF_SHADING_NORMAL_GLSL
#define CALOTYPE_BSDF_SHADING_NORMAL_GLSL

/// The normal that the RGB `texel` of an OpenGL (+Y up) normal map asks for: 2 c - 1 in the frame
/// T, B, n, where T is `dpdu` made perpendicular to the unit normal n, and B = n x T or its
/// opposite, whichever goes with `dpdv`: so mirrored texture coordinates keep their relief. Where
/// the map leans beyond the true surface, its normal is mirrored back.
vec3 mappedNormal(vec3 texel, vec3 n, vec3 dpdu, vec3 dpdv, vec3 ng) {
    vec3 tangent = dpdu - dot(n, dpdu) * n;
    float length2 = dot(tangent, tangent);
    if (length2 == 0.0)
        return n;
    tangent *= inversesqrt(length2);
    vec3 bitangent = cross(n, tangent);
    bitangent = dot(bitangent, dpdv) < 0.0 ? -bitangent : bitangent;
    vec3 slope = 2.0 * texel - 1.0;
    vec3 mapped = slope.x * tangent + slope.y * bitangent + slope.z * n;
    float height = dot(mapped, ng);
    mapped -= height < 0.0 ? 2.0 * height * ng : vec3(0.0);
    float mapped2 = dot(mapped, mapped);
    return mapped2 > 0.0 ? mapped * inversesqrt(mapped2) : n;
}

/// The shading normal, bent just as far as it takes for the mirrored viewer to lie on the true
/// surface's side: the mirrored direction is lifted to the surface, and the normal that mirrors
/// into it is half way between it and the viewer (Keller et al. 2017, "The Iray Light Transport
/// Simulation and Rendering System", section A.3). The viewer then sees the shaded side too. All
/// are unit vectors; wo and ns are on the side of ng.
vec3 consistentNormal(vec3 wo, vec3 ng, vec3 ns) {
    float cosine = dot(wo, ns);
    float height = 2.0 * cosine * dot(ns, ng) - dot(wo, ng); // of the mirrored viewer
    // Cosines to ng: a fiftieth of the viewer's, and at least twice the rounding of a dot product
    // of unit vectors (gamma_3, 4e-7), so that no ray along the surface starts below.
    float least = max(0.02 * dot(wo, ng), 1e-6);
    // Of a direction straight down something has to be left.
    float lowest = max(least, sqrt(max(height * height - 0.9999, 0.0)));
    // With the lifted direction's length, sum = length wo + lifted. The two nearly cancel where the
    // view grazes: so wo + mirrored is put as 2 (wo.ns) ns, and the sum made perpendicular to their
    // difference, which it is but for rounding.
    float excess2 = (lowest - height) * (lowest + height);
    float liftedLength = sqrt(1.0 + excess2);
    vec3 sum = 2.0 * cosine * ns + (lowest - height) * ng + excess2 / (1.0 + liftedLength) * wo;
    vec3 difference = 2.0 * liftedLength * wo - sum;
    float longer2 = max(dot(sum, sum), dot(difference, difference)); // no division by rounding
    vec3 bent = sum - dot(sum, difference) / longer2 * difference;
    // Chosen before the root: CPUs compute both, and numbers too small for float cost them dearly.
    bool isConsistent = height >= least;
    bent = isConsistent ? ns : bent;
    float scale = inversesqrt(dot(bent, bent));
    return isConsistent ? ns : scale * bent;
}

/// The direction, mirrored where it is not on the side of the normal.
vec3 ontoSideOf(vec3 normal, vec3 w) {
    float height = dot(w, normal);
    return height < 0.0 ? w - 2.0 * height * normal : w;
}

#endif
