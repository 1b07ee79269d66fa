// The inputs of a dispatch of a rendering kernel, and its results, in the form of
// shared/declare_structs.h.

// Push constants. A dispatch adds samples to every pixel of its tiles until the pixel has
// `sampleEnd` samples of the block; the storage image holds the samples so far.
STRUCT(RenderParameters)
ROW(uvec2, imageSize, xy)    ///< of the whole film, pixels
FIELD(uvec2, cropOrigin, zw) ///< first pixel of the storage image on the film
ROW(uvec2, cropSize, xy)     ///< of the storage image, pixels
FIELD(uint, firstTile, z)    ///< in the list of tiles
FIELD(uint, firstSample, w)  ///< absolute index of the block's first sample
ROW(uint, sampleEnd, x)      ///< samples of this block to have after the dispatch, at most
FIELD(uint, seed, y)
FIELD(uint, maxBounces, z)
FIELD(uint, lightCount, w)
ROW(uint, iterationBudget, x)  ///< loop iterations after which a subgroup parks its paths
FIELD(float, indirectClamp, y) ///< most of one contribution of light scattered twice or more,
                               ///< W/(m^2 sr)
FIELD(uint, infiniteLight, z)  ///< the light of rays that hit no surface, or kNone
FIELD(uint, lightTreeDepth, w) ///< 0: no tree
END(RenderParameters)

// Sums over one dispatch, added to atomically, once per subgroup.
STRUCT(RenderCounters)
ROW(uint, rays, x)
FIELD(uint, paths, y)
FIELD(uint, nonFiniteSamples, z) ///< samples that are NaN or infinite, added as zero
FIELD(uint, cutPaths, w)         ///< paths ended because one ray takes a whole budget: too dark
ROW(uint, unfinishedPixels, x)   ///< pixels parked before `sampleEnd`, for the next dispatch
FIELD(uint, pad0, y)
FIELD(uint, pad1, z)
FIELD(uint, pad2, w)
END(RenderCounters)

// Push constants. A dispatch finds the first hits of the pixels of a run of tiles, or the features
// that one ray of each of these pixels shows.
STRUCT(RecordParameters)
ROW(uvec2, imageSize, xy)    ///< of the whole film, pixels
FIELD(uvec2, cropOrigin, zw) ///< first pixel of the picture on the film
ROW(uvec2, cropSize, xy)     ///< of the picture, pixels
FIELD(uint, firstTile, z)
FIELD(uint, iterationsBeforeCut, w) ///< loop iterations after which a search ends as it is
ROW(uint, sampleIndex, x)           ///< of the ray; this and the fields below are of features
FIELD(uint, seed, y)
FIELD(uint, infiniteLight, z) ///< the light of rays that hit no surface, or kNone
FIELD(uint, pad0, w)
END(RecordParameters)

#undef STRUCT
#undef ROW
#undef FIELD
#undef END
