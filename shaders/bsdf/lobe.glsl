// The contract of a lobe, which is one way in which a surface scatters light.
//
// A file bsdf/<lobe>.glsl declares a struct, three constants, and these functions, all overloads of
// the same names:
//
//   const bool k<Name>MayBeSpecular       It may scatter to certain directions only.
//   const bool k<Name>Crosses             It may scatter to the far side of the surface.
//   const bool k<Name>CrossesWithDensity  There it has a density; light is sampled there too.
//       Each may depend on features, so that scenes without the lobe do not need the code.
//   <Name>Lobe make<Name>(Material material)
//       From a material whose textures are looked up. Its `eta` is the index of refraction on the
//       far side over that on the viewer's.
//   bool isSpecular(<Name>Lobe lobe)
//       True for a lobe that scatters to certain directions only. It has no density.
//   float lobeAlbedo(<Name>Lobe lobe, vec3 wo)
//       Roughly the share of white light that the lobe scatters, at least 0. The lobes of a
//       material are sampled with probabilities in proportion to it.
//   vec3 evaluateLobe(<Name>Lobe lobe, vec3 wo, vec3 wi)
//       f |cos|: the BSDF in 1/sr times the cosine at the surface. Zero for a specular lobe.
//   float lobePdf(<Name>Lobe lobe, vec3 wo, vec3 wi)
//       The density, per solid angle of wi, with which sampleLobe draws wi. Zero for a specular
//       lobe; above zero wherever evaluateLobe is.
//   LobeSample sampleLobe(<Name>Lobe lobe, vec3 wo, vec3 u)
//       Draws a direction; each component of u is uniform in [0, 1).
//
// Directions are unit vectors in the shading frame, away from the surface: z is the shading normal
// on the viewer's side. wo.z > 0. wi may lie on either side: wi.z > 0 is a reflection, wi.z < 0 a
// transmission. Every function accepts both, and evaluateLobe and lobePdf return zero on a side to
// which the lobe does not scatter. A sampled direction may lie on such a side; it then counts as
// no light.
//
// To add a lobe: write its file, include it in bsdf/lobes.glsl, and give it a line LOBE in
// shared/feature_table.h, from which bsdf/bsdf.glsl calls its functions.
#ifndef CALOTYPE_BSDF_LOBE_GLSL
#define CALOTYPE_BSDF_LOBE_GLSL

struct LobeSample {
    vec3 wi;
    bool isSpecular;     ///< a discrete direction, without a density
    vec3 specularWeight; ///< f |cos| / pdf of a specular direction; else 0, because the weight
                         ///< follows from evaluateLobe and lobePdf
    float eta; ///< index of refraction on wi's side over that on the viewer's; 1 if wi is not bent
};

/// A direction that has a density.
LobeSample lobeSample(vec3 wi) { return LobeSample(wi, false, vec3(0.0), 1.0); }

#endif
