// Descriptor bindings of set 0, one per line, numbered by lines: no other line between them. Each
// line defines a constant such as kBindingCamera (shared/bindings.h).
//
// The bindings of the packed scene are texel buffers of 16-byte rows (the fastest fetch on
// llvmpipe, measured). SCENE_ARRAY is an array of structs: identifier, struct, member of GpuScene,
// display name. Its line also defines that member (host/pack/gpu_scene.h), the buffer and the
// function loadX of struct X (buffers/packed_scene.glsl), the upload
// (host/render/scene_buffers.cpp) and a test (tests/gpu/layout_test.cpp). SCENE_ROWS is an array of
// rows without a struct; its second column is the C++ type of an element.
BEGIN_BINDINGS
SCENE_ARRAY(Nodes, BvhNode, nodes, "BVH nodes")
SCENE_ARRAY(Triangles, Triangle, triangles, "triangles")
SCENE_ARRAY(TriangleNormals, TriangleNormals, triangleNormals, "triangle normals")
SCENE_ARRAY(TriangleUvs, TriangleUvs, triangleUvs, "texture coordinates")
SCENE_ARRAY(Quadrics, Quadric, quadrics, "quadrics")
SCENE_ARRAY(Materials, Material, materials, "materials")
SCENE_ARRAY(Textures, Texture, textures, "textures")
SCENE_ARRAY(Lights, Light, lights, "lights")
SCENE_ARRAY(Filter, FilterStep, filterSteps, "film filter")
SCENE_ARRAY(LightNodes, LightNode, lightNodes, "light tree")
SCENE_ROWS(Texels, TexelRows, texelRows, "texels")
BINDING(Camera)      // uniform buffer
BINDING(Block)       // storage image
BINDING(Counters)    // storage buffer
BINDING(FirstHits)   // storage buffer: a FirstHitRecord, in words, for each pixel of the tiles
BINDING(Features)    // storage buffer: a FeatureRecord, in words, for each pixel of the tiles
BINDING(ParkedTasks) // storage buffer: a ParkedTask for each task of each lane
BINDING(Rays)        // storage buffer of ListedRay
BINDING(ListedHits)  // storage buffer of ListedHit
BINDING(Tiles)       // storage buffer: numbers of the tiles to render, in the order to take them
BINDING(NoisyPixels) // texel buffer: rows of DenoiserPixel
BINDING(WeightSums)  // storage buffer: a float for each of the noisy pixels
BINDING(CleanPixels) // storage buffer: a vec4 for each of the noisy pixels
END_BINDINGS
#undef BEGIN_BINDINGS
#undef SCENE_ARRAY
#undef SCENE_ROWS
#undef BINDING
#undef END_BINDINGS
