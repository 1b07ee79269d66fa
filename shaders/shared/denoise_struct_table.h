// What the statistical denoiser reads on a device, in the form of shared/declare_structs.h.

// The mean of the replicas in a pixel or a patch, and what counts as the variance of that mean.
STRUCT(NoisyColor)
ROW(vec3, mean, xyz)
FIELD(uint, pad0, w)
ROW(vec3, variance, xyz)
FIELD(uint, pad1, w)
END(NoisyColor)

STRUCT(PixelGuides)
ROW(vec3, albedo, xyz)
FIELD(uint, pad0, w)
ROW(vec3, normal, xyz)
FIELD(uint, pad1, w)
END(PixelGuides)

// Push constants. A dispatch denoises the pixels of a run of tiles of a window of the picture.
STRUCT(DenoiserParameters)
ROW(uvec2, windowSize, xy) ///< pixels
FIELD(uint, firstTile, z)
FIELD(float, squaredBound, w) ///< of differences, over the sum of their variances
END(DenoiserParameters)

#undef STRUCT
#undef ROW
#undef FIELD
#undef END
