// Specialization constants beside the features. Each line is one: identifier, type, name in GLSL,
// default. Each line defines kConstantSobol (shared/specialization.h) and the constant itself
// (config/settings.glsl). They are numbered by lines, like the features.
BEGIN_SETTINGS
SETTING(SubgroupSize, uint, kSubgroupSize, 1u) // of a workgroup, which is one subgroup
SETTING(NodeEighths, uint, kNodeEighths, 5u)   // these five adapt the kernel to a device
SETTING(PrimitiveEighths, uint, kPrimitiveEighths, 3u)
SETTING(RayEighths, uint, kRayEighths, 7u)
SETTING(EventEighths, uint, kEventEighths, 6u)
SETTING(SharesStack, bool, sharesStack, false)
SETTING(Sobol, bool, usesSobol, false) // random numbers are Sobol's
SETTING(Mis, bool, usesMis, true)      // these three: how paths find light
SETTING(Roulette, bool, usesRoulette, true)
SETTING(ClampsIndirect, bool, clampsIndirect, true)
END_SETTINGS
#undef BEGIN_SETTINGS
#undef SETTING
#undef END_SETTINGS
