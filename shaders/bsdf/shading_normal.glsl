// Shading normals: from normal maps, and made consistent with the true surface.
#ifndef CALOTYPE_BSDF_SHADING_NORMAL_GLSL
#define CALOTYPE_BSDF_SHADING_NORMAL_GLSL

/// The normal that the RGB `texel` of an OpenGL (+Y up) normal map stands for: 2 c - 1 in the frame
/// T, B, n. T is `dpdu` made perpendicular to the unit normal n. B is n x T or its opposite, on the
/// side of `dpdv`, so that a mirrored texture keeps its relief. A normal that points below the true
/// surface is mirrored to the upper side.
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

/// The shading normal, bent only as far as needed for the reflected view direction to lie above the
/// true surface: that direction is lifted to the surface, and the normal is half way between it and
/// the viewer (Keller et al. 2017, "The Iray Light Transport Simulation and Rendering System",
/// section A.3). Then the viewer also sees the shaded side. All are unit vectors; wo and ns are on
/// the side of ng.
vec3 consistentNormal(vec3 wo, vec3 ng, vec3 ns) {
    float cosine = dot(wo, ns);
    float height = 2.0 * cosine * dot(ns, ng) - dot(wo, ng); // of the reflected view direction
    // Least cosine to ng: a fiftieth of the viewer's, and at least twice the rounding of a dot
    // product of unit vectors (gamma_3, 4e-7), so that no ray along the surface starts below it.
    float least = max(0.02 * dot(wo, ng), 1e-6);
    // Leaves a remainder of a direction that points straight down.
    float lowest = max(least, sqrt(max(height * height - 0.9999, 0.0)));
    // With the lifted direction's length, sum = length wo + lifted. The two terms nearly cancel at
    // grazing views. So wo + mirrored is computed as 2 (wo.ns) ns, and the sum is made
    // perpendicular to the difference, as it is in exact arithmetic.
    float excess2 = (lowest - height) * (lowest + height);
    float liftedLength = sqrt(1.0 + excess2);
    vec3 sum = 2.0 * cosine * ns + (lowest - height) * ng + excess2 / (1.0 + liftedLength) * wo;
    vec3 difference = 2.0 * liftedLength * wo - sum;
    float longer2 = max(dot(sum, sum), dot(difference, difference)); // so the divisor is not noise
    vec3 bent = sum - dot(sum, difference) / longer2 * difference;
    // Chosen before the root: CPUs compute both branches, and are slow with denormal numbers.
    bool isConsistent = height >= least;
    bent = isConsistent ? ns : bent;
    float scale = inversesqrt(dot(bent, bent));
    return isConsistent ? ns : scale * bent;
}

/// The direction, mirrored if it is not on the side of the normal.
vec3 ontoSideOf(vec3 normal, vec3 w) {
    float height = dot(w, normal);
    return height < 0.0 ? w - 2.0 * height * normal : w;
}

#endif
