// Specialization constants beside the features, one a line: identifier, type, name in GLSL and
// default. From a line come kConstantSobol (shared/specialization.h) and the constant itself
// (config/settings.glsl). Numbered by lines, like the features.
BEGIN_SETTINGS
SETTING(SubgroupSize, uint, kSubgroupSize, 1u) // of a workgroup, which is one subgroup
SETTING(NodeEighths, uint, kNodeEighths, 5u)   // these five suit the kernel to a device
SETTING(PrimitiveEighths, uint, kPrimitiveEighths, 3u)
SETTING(RayEighths, uint, kRayEighths, 7u)
SETTING(EventEighths, uint, kEventEighths, 6u)
SETTING(SharesStack, bool, sharesStack, false)
SETTING(Sobol, bool, usesSobol, false) // random numbers are Sobol's
SETTING(Mis, bool, usesMis, true)      // how light is looked for along a path
SETTING(Roulette, bool, usesRoulette, true)
SETTING(ClampsIndirect, bool, clampsIndirect, true)
END_SETTINGS
#undef BEGIN_SETTINGS
#undef SETTING
#undef END_SETTINGS
