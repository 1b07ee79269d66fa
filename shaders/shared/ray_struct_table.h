// Lists of rays, which are traced without any shading, as shared/declare_structs.h says.

STRUCT(ListedRay)
ROW(vec3, origin, xyz) ///< metres from the packed scene's origin
FIELD(float, tMax, w)  ///< metres; 0 if a pixel has no such ray
ROW(vec3, direction, xyz)
FIELD(uint, target, w) ///< the primitive that the ray ignores, or kNone
END(ListedRay)

// What a ray hit: the closest hit or, for shadow rays, any hit.
STRUCT(ListedHit)
ROW(float, t, x)          ///< metres; the ray's tMax if it hit nothing
FIELD(uint, primitive, y) ///< as kQuadricBit says, or kNone
FIELD(uint, pad0, z)
FIELD(uint, pad1, w)
END(ListedHit)

// Push constants of both kernels, the one that lists rays and the one that traces them.
STRUCT(RayListParameters)
ROW(uvec2, imageSize, xy)  ///< pixels
FIELD(uint, firstGroup, z) ///< tiles of the picture, or kRaysPerGroup consecutive rays
FIELD(uint, groupCount, w)
ROW(uint, groupStride, x) ///< group g of the dispatch takes group g * groupStride % groupCount
FIELD(uint, rayCount, y)
FIELD(uint, isShadow, z) ///< 1 for rays to lights, from the hits of primary rays
FIELD(uint, bounces, w)  ///< for other rays: scattering events before the ray
ROW(uint, seed, x)
FIELD(uint, lightCount, y)
FIELD(uint, iterationBudget, z)
FIELD(uint, lightTreeDepth, w) ///< 0: no tree
ROW(uint, infiniteLight, x)    ///< the light of rays that hit no surface, or kNone
FIELD(uint, pad0, y)
FIELD(uint, pad1, z)
FIELD(uint, pad2, w)
END(RayListParameters)

#undef STRUCT
#undef ROW
#undef FIELD
#undef END
