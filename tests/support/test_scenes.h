#pragma once

#include <vector>

#include "pack/gpu_scene.h"
#include "scene/scene.h"

namespace calotype::test {

/// A scene of shapes and one material, a grey, with the number 0; the camera is at the origin.
Scene sceneOf(std::vector<Shape> shapes);

Shape shapeOf(std::variant<Sphere, Cylinder, Cone, Disk, Mesh> geometry, uint32_t material = 0);

/// An icosahedron, each triangle cut into four `level` times, its corners on a sphere: closed, all
/// corners shared, outside outward.
Mesh icosphere(uint32_t level, const glm::dvec3& center, double radius);

/// A mesh of one triangle.
Mesh singleTriangle(const glm::dvec3& v0, const glm::dvec3& v1, const glm::dvec3& v2);

/// The surface of an axis-aligned cube about the origin with sides of 2, each side cut into
/// n x n squares of two triangles: closed, corners bit-identical.
Mesh cubeMesh(uint32_t n);

/// A packed scene with its tree, made as the program makes it.
struct PackedScene {
    std::vector<Primitive> primitives;
    Bvh bvh;
    GpuScene packed;
};
PackedScene packAsProgram(const Scene& scene, LightChoice choice = LightChoice::Power);

} // namespace calotype::test
