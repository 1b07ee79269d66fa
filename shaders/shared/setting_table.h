// Specialization constants beside the features. Each line is one: identifier, type, name in GLSL,
// default, its value on the host. Each line defines kConstantSobol (shared/specialization.h), the
// constant itself (config/settings.glsl), and what the host sets it to (render/specialization.cpp,
// which says what names the last column may use). They are numbered by lines, like the features.
BEGIN_SETTINGS
SETTING(SubgroupSize, uint, kSubgroupSize, 1u, info.subgroupSize) // of a workgroup, a subgroup
SETTING(NodeEighths, uint, kNodeEighths, 5u, tuned.nodeEighths)   // these five suit the device
SETTING(PrimitiveEighths, uint, kPrimitiveEighths, 3u, tuned.primitiveEighths)
SETTING(RayEighths, uint, kRayEighths, 7u, tuned.rayEighths)
SETTING(EventEighths, uint, kEventEighths, 6u, tuned.eventEighths)
SETTING(SharesStack, bool, sharesStack, false, tuned.sharesStack)
SETTING(Sobol, bool, usesSobol, false, sampler == Sampler::Sobol) // random numbers are Sobol's
SETTING(Mis, bool, usesMis, true, transport.usesMis) // these three: how paths find light
SETTING(Roulette, bool, usesRoulette, true, transport.usesRoulette)
SETTING(ClampsIndirect, bool, clampsIndirect, true, transport.clampsIndirect())
SETTING(HidesBackground, bool, hidesBackground, false, transport.hidesBackground)
END_SETTINGS
#undef BEGIN_SETTINGS
#undef SETTING
#undef END_SETTINGS
