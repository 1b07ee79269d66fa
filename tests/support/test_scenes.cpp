#include "support/test_scenes.h"

#include <array>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "engine/compile_scene.h"

namespace calotype::test {
namespace {

using Corners = std::array<uint32_t, 3>;

constexpr uint32_t kNoNormal = Mesh::kNoNormal;

void addTriangle(Mesh& mesh, const Corners& c) {
    mesh.triangles.push_back({{c[0], c[1], c[2]}, {kNoNormal, kNoNormal, kNoNormal}, 0});
}

/// The index of the point in the middle of an edge, made on first use.
class EdgeMiddles {
public:
    explicit EdgeMiddles(std::vector<glm::dvec3>& points) : points_(points) {}

    uint32_t operator()(uint32_t a, uint32_t b) {
        const auto [found, isNew] = indices_.try_emplace(std::minmax(a, b), points_.size());
        if (isNew)
            points_.push_back(glm::normalize(points_[a] + points_[b]));
        return found->second;
    }

private:
    std::vector<glm::dvec3>& points_;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> indices_;
};

std::vector<Corners> subdivided(const std::vector<Corners>& triangles,
                                std::vector<glm::dvec3>& points) {
    EdgeMiddles middle(points);
    std::vector<Corners> result;
    for (const auto& [a, b, c] : triangles) {
        const uint32_t ab = middle(a, b);
        const uint32_t bc = middle(b, c);
        const uint32_t ca = middle(c, a);
        result.insert(result.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return result;
}

} // namespace

Scene sceneOf(std::vector<Shape> shapes) {
    Scene scene;
    scene.shapes = std::move(shapes);
    Material grey;
    grey.name = "grey";
    grey.color = glm::dvec3(0.5);
    scene.materials = {grey};
    return scene;
}

Shape shapeOf(std::variant<Sphere, Cylinder, Cone, Disk, Mesh> geometry, uint32_t material) {
    Shape shape;
    shape.geometry = std::move(geometry);
    shape.material = material;
    return shape;
}

Mesh icosphere(uint32_t level, const glm::dvec3& center, double radius) {
    const double g = (1.0 + std::sqrt(5.0)) / 2.0;
    std::vector<glm::dvec3> points = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                      {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                      {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    std::vector<Corners> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (glm::dvec3& point : points)
        point = glm::normalize(point);
    for (uint32_t i = 0; i < level; ++i)
        triangles = subdivided(triangles, points);
    Mesh mesh;
    for (const glm::dvec3& point : points)
        mesh.positions.push_back(center + radius * point);
    for (const Corners& corners : triangles)
        addTriangle(mesh, corners);
    return mesh;
}

Mesh singleTriangle(const glm::dvec3& v0, const glm::dvec3& v1, const glm::dvec3& v2) {
    Mesh mesh;
    mesh.positions = {v0, v1, v2};
    addTriangle(mesh, {0, 1, 2});
    return mesh;
}

Mesh cubeMesh(uint32_t n) {
    Mesh mesh;
    const auto corner = [n](uint32_t i) { return 2.0 * i / n - 1.0; };
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const auto point = [&](uint32_t i, uint32_t j) {
                glm::dvec3 p;
                p[axis] = side;
                p[(axis + 1) % 3] = side * corner(i);
                p[(axis + 2) % 3] = corner(j);
                mesh.positions.push_back(p);
                return static_cast<uint32_t>(mesh.positions.size() - 1);
            };
            for (uint32_t i = 0; i < n; ++i) {
                for (uint32_t j = 0; j < n; ++j) {
                    const uint32_t a = point(i, j);
                    const uint32_t c = point(i + 1, j + 1);
                    addTriangle(mesh, {a, point(i + 1, j), c});
                    addTriangle(mesh, {a, c, point(i, j + 1)});
                }
            }
        }
    }
    return mesh;
}

PackedScene packAsProgram(const Scene& scene, LightChoice choice) {
    RenderSettings settings;
    settings.transport.lightChoice = choice;
    settings.width = settings.height = 1;
    settings.bvh = BvhBuilder::Sah;
    CompiledScene compiled = compileScene(scene, settings);
    return {std::move(compiled.primitives), std::move(compiled.bvh), std::move(compiled.packed)};
}

} // namespace calotype::test
