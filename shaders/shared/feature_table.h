// The features of a scene that a kernel is specialised for. Each line is one: identifier and
// display name. Each line defines kFeatureTriangles (shared/specialization.h), hasTriangles
// (config/features.glsl), the name (host/pack/scene_features.cpp) and a test (kTrianglesCase,
// tests/support/feature_cases.cpp). The feature's number is the line's distance from the first, so
// there must be no other line between them.
//
// LIGHT is a kind of light: identifier, sort and name. Its feature is TriangleLights. From its line
// also come kLightTriangle (shared/scene_structs.h) and the calls of its functions
// (lights/light.glsl). These lines follow each other. The sorts are
//   Area            a surface with its own way of sampling,
//   UniformQuadric  a quadric that is sampled by uniform points on its area,
//   Infinite        infinitely far away.
//
// LOBE is a lobe: identifier, name of its member in Bsdf, and name for people. Its feature is
// Diffuse. From its line also come kLobeDiffuse (shared/scene_structs.h), its part of a Bsdf and
// the calls of its functions (bsdf/bsdf.glsl). These lines follow each other. A material has at
// most one of GGX and Blinn-Phong; a dielectric has no other lobe.
//
// The macros that the including file does not define: LIGHT and LOBE are FEATURE, others are empty.
#ifndef BEGIN_FEATURES
#define BEGIN_FEATURES
#endif
#ifndef FEATURE
#define FEATURE(id, people)
#endif
#ifndef LIGHT
#define LIGHT(id, sort, people) FEATURE(id##Lights, people)
#endif
#ifndef LOBE
#define LOBE(id, member, people) FEATURE(id, people)
#endif
#ifndef END_FEATURES
#define END_FEATURES
#endif
BEGIN_FEATURES
FEATURE(Triangles, "triangles")
FEATURE(SmoothNormals, "smooth normals")
FEATURE(Spheres, "spheres") // these four are in the order of Quadric::kind
FEATURE(Cylinders, "cylinders")
FEATURE(Cones, "cones")
FEATURE(Disks, "disks")
FEATURE(ManyQuadrics, "many quadrics") // too many for rays to wait before quadrics
LIGHT(Triangle, Area, "triangle lights")
LIGHT(Sphere, Area, "sphere lights") // these four are in the order of Quadric::kind
LIGHT(Cylinder, UniformQuadric, "cylinder lights")
LIGHT(Cone, UniformQuadric, "cone lights")
LIGHT(Disk, UniformQuadric, "disk lights")
LIGHT(Background, Infinite, "a background")
FEATURE(HiddenLights, "hidden lights")
FEATURE(LightAlpha, "lights with alpha")
FEATURE(SolidAngleLights, "lights sampled by solid angle")
FEATURE(LightTree, "a light tree")
LOBE(Diffuse, diffuse, "diffuse")
LOBE(Ggx, ggx, "GGX")
LOBE(BlinnPhong, blinnPhong, "Blinn-Phong")
LOBE(Dielectric, dielectric, "dielectrics")
FEATURE(Mirrors, "mirrors") // GGX of almost no roughness
FEATURE(ColorTextures, "color textures")
FEATURE(RoughnessTextures, "roughness textures")
FEATURE(SpecularTextures, "specular textures")
FEATURE(NormalMaps, "normal maps")
FEATURE(Alpha, "alpha")
FEATURE(CutOutColors, "colors of cut-outs") // of images whose own alpha weighs their texels
FEATURE(ByteTexels, "8-bit images")
FEATURE(FloatTexels, "float images")
FEATURE(Checkers, "checkers")
FEATURE(Filter, "a film filter") // any except the box
FEATURE(Lens, "a lens")
FEATURE(Orthographic, "an orthographic camera")
END_FEATURES
#undef BEGIN_FEATURES
#undef FEATURE
#undef LIGHT
#undef LOBE
#undef END_FEATURES
