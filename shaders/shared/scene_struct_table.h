// The structs of the packed scene, in the form of shared/declare_structs.h. Lengths are metres, in
// a frame whose origin the host moved near the camera.

// A node has up to eight children. Their boxes are on a grid over the node's own box: cell
// boundaries are at origin + k * size, k from 0 to 255, size a power of two. Triangles of leaves
// are consecutive from `firstTriangle` on and quadrics from `firstQuadric` on, each in the order of
// the children. Each side of the boxes has a byte per child, the first child's lowest.
STRUCT(BvhNode)
ROW(vec3, origin, xyz)
FIELD(uint, nodesAndExponents, w) ///< bytes: exponents of size.xyz as a float's, and a bit for each
                                  ///< child that is a node
ROW(uint, childBase, x) ///< the child in slot i, if it is a node, is at childBase + i; 24 bits
FIELD(uint, firstTriangle, y)
FIELD(uint, firstQuadric, z)
FIELD(uint, primitives, w) ///< three bits a child, as many set as it has primitives; in the highest
                           ///< byte, a bit for each child whose primitives are quadrics
ROW(uvec2, lowerX, xy)
FIELD(uvec2, upperX, zw)
ROW(uvec2, lowerY, xy)
FIELD(uvec2, upperY, zw)
ROW(uvec2, lowerZ, xy)
FIELD(uvec2, upperZ, zw)
END(BvhNode)

// Triangles that share a corner have bit-identical corners: watertightness depends on it. A
// triangle is one cache line of most processors; a ray needs only its first three rows.
STRUCT(Triangle)
ROW(vec3, v0, xyz)
FIELD(float, normalX, w) ///< unit normal of the front, each component rounded to the nearest float
ROW(vec3, v1, xyz)
FIELD(float, normalY, w)
ROW(vec3, v2, xyz)
FIELD(float, normalZ, w)
ROW(uint, material, x) ///< index, with kTransparentBit
FIELD(uint, light, y)  ///< index of its light, or kNone
FIELD(uint, id, z)     ///< number of the primitive in the order of the scene file
FIELD(uint, pad0, w)
END(Triangle)

// Shading normals at the corners of the triangle of the same index; zero if it has none.
STRUCT(TriangleNormals)
ROW(vec3, n0, xyz)
FIELD(uint, pad0, w)
ROW(vec3, n1, xyz)
FIELD(uint, pad1, w)
ROW(vec3, n2, xyz)
FIELD(uint, pad2, w)
END(TriangleNormals)

// Texture coordinates at the corners of the triangle of the same index.
STRUCT(TriangleUvs)
ROW(vec2, uv0, xy)
FIELD(vec2, uv1, zw)
ROW(vec2, uv2, xy)
FIELD(uint, pad0, z)
FIELD(uint, pad1, w)
END(TriangleUvs)

// Sphere, cylinder, cone or disk in a local frame with axis y. `extent` is the height of a cylinder
// or the signed height of a cone; `radius` of a cone is that of its base.
STRUCT(Quadric)
ROW(vec3, center, xyz) ///< of a sphere, cylinder or disk; a cone's apex
FIELD(float, radius, w)
ROW(vec3, axisX, xyz) ///< the frame's axes in the world: orthonormal
FIELD(float, extent, w)
ROW(vec3, axisY, xyz)
FIELD(uint, kind, w) ///< kSphere, kCylinder, kCone or kDisk
ROW(vec3, axisZ, xyz)
FIELD(float, slope, w) ///< of a cone: radius / |y|
ROW(uint, material, x) ///< index, with kTransparentBit
FIELD(uint, light, y)
FIELD(uint, id, z)
FIELD(uint, pad0, w)
ROW(vec3, centerRest, xyz) ///< of a sphere: the rounding error of its centre
FIELD(uint, pad1, w)
END(Quadric)

// A texture, if there is one, multiplies the number of the same name.
STRUCT(Material)
ROW(vec3, color, xyz) ///< reflectance, F0 or tint
FIELD(uint, colorTexture, w)
ROW(float, roughness, x)
FIELD(uint, roughnessTexture, y)
FIELD(float, specular, z) ///< F0 of a nonmetal, ks of Blinn-Phong
FIELD(uint, specularTexture, w)
ROW(uint, lobes, x) ///< kLobe... and flags for its numbers
FIELD(uint, normalMap, y)
FIELD(uint, alphaTexture, z)
FIELD(float, opacity, w)
ROW(float, kd, x)         ///< Blinn-Phong: weight of the diffuse lobe
FIELD(float, exponent, y) ///< Blinn-Phong
FIELD(float, eta, z)      ///< dielectric: index of refraction inside over outside
FIELD(uint, pad0, w)
END(Material)

// An image, or a checker of two colours.
STRUCT(Texture)
ROW(vec2, scale, xy) ///< read at uv * scale + offset
FIELD(vec2, offset, zw)
ROW(uint, firstRow, x) ///< of its texels
FIELD(uint, width, y)
FIELD(uint, height, z)
FIELD(uint, flags, w) ///< kTexture...
ROW(vec3, color0, xyz)
FIELD(uint, pad0, w)
ROW(vec3, color1, xyz)
FIELD(uint, pad1, w)
END(Texture)

// A light: an emitting primitive or the background. It includes a column of the alias table that
// chooses lights or, if a tree chooses them, its place in the tree.
STRUCT(Light)
ROW(vec3, radiance, xyz)
FIELD(uint, primitive, w)             ///< kNone for a light that is infinitely far away
ROW(float, area, x)                   ///< m^2; 0 for a light that is infinitely far away
FIELD(float, selectionProbability, y) ///< probability with which this light is chosen; of a light
                                      ///< of the tree, with which the tree is
FIELD(uint, firstNumber, z) ///< of the random numbers that fall into the column, in units of 2^-24
FIELD(uint, ownNumbers, w)  ///< those of them that choose this light; they come first
ROW(uint, aliasNumbers, x)  ///< those after them; they choose the light `alias`
FIELD(uint, alias, y)       ///< in the tree instead: the trail, LightTree::trails
FIELD(uint, flags, z)       ///< kLightEmitsFromBack...
FIELD(uint, kind, w)        ///< kLightTriangle...
END(Light)

// A step of the table of the film filter's quantiles: the distances from a pixel's centre along one
// axis, in pixels, at its begin and at its end.
STRUCT(FilterStep)
ROW(vec2, quantiles, xy)
FIELD(uint, pad0, z)
FIELD(uint, pad1, w)
END(FilterStep)

// A node of the light tree: two clusters of lights (docs/models.md, "Light tree").
STRUCT(LightNode)
ROW(vec3, center0, xyz) ///< of a sphere around the first cluster
FIELD(float, radius0, w)
ROW(vec3, axis0, xyz) ///< unit: normals of lit sides are within an angle of it
FIELD(float, cosThetaO0, w)
ROW(vec3, center1, xyz)
FIELD(float, radius1, w)
ROW(vec3, axis1, xyz)
FIELD(float, cosThetaO1, w)
ROW(float, power0, x) ///< as a share of the node's
FIELD(float, power1, y)
FIELD(uint, child0, z) ///< index of a node or, with kChildIsLight, of a light; may have
                       ///< kChildIsTwoSided
FIELD(uint, child1, w)
END(LightNode)

// Perspective: `right` and `up` go from the centre of the image plane, one unit along `forward`, to
// its edges. Orthographic: they go from `position` to the edges of the view.
STRUCT(Camera)
ROW(vec3, position, xyz)
FIELD(float, focusDistance, w) ///< along forward, metres
ROW(vec3, right, xyz)
FIELD(uint, isOrthographic, w)
ROW(vec3, up, xyz)
FIELD(uint, filterIsBox, w) ///< of the film; 0: the filter of the table
ROW(vec3, forward, xyz)
FIELD(uint, pad0, w)
ROW(vec3, lensRight, xyz) ///< the lens's radius along right and up; zero for a pinhole
FIELD(uint, pad1, w)
ROW(vec3, lensUp, xyz)
FIELD(uint, pad2, w)
END(Camera)

#undef STRUCT
#undef ROW
#undef FIELD
#undef END
