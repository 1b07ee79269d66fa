// The features of a scene that a kernel is specialised for. Each line is one: identifier and
// display name. Each line defines kFeatureTriangles (shared/specialization.h), hasTriangles
// (config/features.glsl), the name (host/pack/scene_features.cpp) and a test (kTrianglesCase,
// tests/support/feature_cases.cpp). The feature's number is the line's distance from the first, so
// there must be no other line between them.
BEGIN_FEATURES
FEATURE(Triangles, "triangles")
FEATURE(SmoothNormals, "smooth normals")
FEATURE(Spheres, "spheres") // these four are in the order of Quadric::kind
FEATURE(Cylinders, "cylinders")
FEATURE(Cones, "cones")
FEATURE(Disks, "disks")
FEATURE(ManyQuadrics, "many quadrics") // too many for rays to wait before quadrics
FEATURE(TriangleLights, "triangle lights")
FEATURE(SphereLights, "sphere lights") // these four are in the order of Quadric::kind
FEATURE(CylinderLights, "cylinder lights")
FEATURE(ConeLights, "cone lights")
FEATURE(DiskLights, "disk lights")
FEATURE(HiddenLights, "hidden lights")
FEATURE(LightAlpha, "lights with alpha")
FEATURE(Background, "a background")
FEATURE(Diffuse, "diffuse")
FEATURE(Ggx, "GGX")
FEATURE(Mirrors, "mirrors") // GGX of almost no roughness
FEATURE(BlinnPhong, "Blinn-Phong")
FEATURE(Dielectrics, "dielectrics")
FEATURE(ColorTextures, "color textures")
FEATURE(RoughnessTextures, "roughness textures")
FEATURE(SpecularTextures, "specular textures")
FEATURE(NormalMaps, "normal maps")
FEATURE(Alpha, "alpha")
FEATURE(ByteTexels, "8-bit images")
FEATURE(FloatTexels, "float images")
FEATURE(Checkers, "checkers")
FEATURE(Filter, "a film filter") // any except the box
FEATURE(Lens, "a lens")
FEATURE(Orthographic, "an orthographic camera")
END_FEATURES
#undef BEGIN_FEATURES
#undef FEATURE
#undef END_FEATURES
