#include "engine/bench_scene.h"

#include <array>
#include <cmath>
#include <numbers>

namespace calotype {
namespace {

constexpr uint32_t kNo = Mesh::kNoNormal;

struct Ball {
    glm::dvec3 center;
    double radius; ///< metres, without the bumps
};

constexpr std::array<Ball, 3> kBalls = {
    {{{0, 0, 0}, 0.7}, {{0.9, 0.2, -0.5}, 0.5}, {{-0.9, -0.3, -0.4}, 0.5}}};

/// Relative height of the ball's surface in a direction: waves of many lengths.
double bump(const glm::dvec3& n) {
    using std::cos;
    using std::sin;
    return 0.06 * sin(9 * n.x + 3 * sin(7 * n.y)) * sin(8 * n.y + 2 * cos(5 * n.z)) * cos(7 * n.z) +
           0.02 * sin(40 * n.x) * sin(41 * n.y) * sin(43 * n.z);
}

/// A grid in longitude and latitude.
Shape makeBall(const Ball& ball, uint32_t material) {
    constexpr uint32_t kLongitudes = 512;
    constexpr uint32_t kLatitudes = 257; // 262,144 triangles: one per cell at the poles, else two
    Mesh mesh;
    for (uint32_t i = 0; i <= kLongitudes; ++i)
        for (uint32_t j = 0; j <= kLatitudes; ++j) {
            const glm::dvec2 uv(double(i) / kLongitudes, double(j) / kLatitudes);
            const double theta = std::numbers::pi * uv.y;
            const double phi = 2.0 * std::numbers::pi * uv.x;
            const glm::dvec3 n(std::sin(theta) * std::cos(phi), std::cos(theta),
                               std::sin(theta) * std::sin(phi));
            const double radius = ball.radius * (1.0 + bump(n + glm::dvec3(ball.center.x, 0, 0)));
            mesh.positions.push_back(ball.center + radius * n);
            mesh.uvs.push_back(uv);
        }
    const auto vertex = [](uint32_t i, uint32_t j) { return i * (kLatitudes + 1) + j; };
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
        mesh.triangles.push_back({{a, b, c}, {kNo, kNo, kNo}, material, {a, b, c}});
    };
    for (uint32_t i = 0; i < kLongitudes; ++i)
        for (uint32_t j = 0; j < kLatitudes; ++j) {
            if (j + 1 < kLatitudes) // at the pole this one has no area
                add(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
            if (j > 0)
                add(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        }
    Shape shape;
    shape.geometry = std::move(mesh);
    return shape;
}

/// A rectangle from a corner and two edges; its front is on the side of their cross product.
Shape makeRectangle(const glm::dvec3& corner, const glm::dvec3& edgeU, const glm::dvec3& edgeV,
                    uint32_t material) {
    Mesh mesh;
    mesh.positions = {corner, corner + edgeU, corner + edgeU + edgeV, corner + edgeV};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{{0, 1, 2}, {kNo, kNo, kNo}, material, {0, 1, 2}},
                      {{0, 2, 3}, {kNo, kNo, kNo}, material, {0, 2, 3}}};
    Shape shape;
    shape.geometry = std::move(mesh);
    return shape;
}

Material makeDiffuse(double reflectance) {
    Material material;
    material.color = glm::dvec3(reflectance);
    return material;
}

Material makeLamp(double radiance) {
    Material material;
    material.emission = glm::dvec3(radiance);
    material.emitsFromFrontOnly = true;
    return material;
}

Material ofType(MaterialType type, const glm::dvec3& color, double roughness = 0.0) {
    Material material;
    material.type = type;
    material.color = color;
    material.roughness = roughness;
    return material;
}

template <typename Geometry>
Shape makeShape(Geometry geometry, uint32_t material) {
    Shape shape;
    shape.geometry = std::move(geometry);
    shape.material = material;
    return shape;
}

RigidTransform at(const glm::dvec3& position) {
    RigidTransform transform;
    transform.translation = position;
    return transform;
}

Scene emptyScene() {
    Scene scene;
    scene.camera.position = {0.0, 0.0, 3.2};
    scene.camera.verticalFov = 2.0 * std::atan(0.45);
    scene.film = {512, 512};
    scene.render = {4, 3, 0};
    return scene;
}

} // namespace

Scene makeBenchScene() {
    Scene scene = emptyScene();
    scene.materials = {makeDiffuse(0.7), makeDiffuse(0.5), makeLamp(10.0)};
    for (const Ball& ball : kBalls)
        scene.shapes.push_back(makeBall(ball, 0));
    scene.shapes.push_back(makeRectangle({-3, -0.9, 3}, {6, 0, 0}, {0, 0, -6}, 1));
    scene.shapes.push_back(makeRectangle({-0.8, 2.5, 0.2}, {1.6, 0, 0}, {0, 0, 1.6}, 2));
    return scene;
}

Scene makeManyMaterialScene() {
    Scene scene = emptyScene();
    scene.textures = {
        {"checks", CheckerTexture{{glm::dvec3(0.8, 0.7, 0.6), glm::dvec3(0.2)}}, {24, 24}, {}}};
    Material floor = makeDiffuse(1.0);
    floor.colorTexture = 0;
    Material phong = ofType(MaterialType::BlinnPhong, {0.3, 0.5, 0.3});
    phong.kd = 0.6;
    phong.ks = 0.3;
    phong.exponent = 60.0;
    Material plastic = ofType(MaterialType::Nonmetal, {0.6, 0.2, 0.1}, 0.3);
    plastic.roughnessTexture = 0;
    scene.materials = {plastic,
                       ofType(MaterialType::Metal, {0.9, 0.7, 0.3}, 0.25),
                       ofType(MaterialType::Metal, glm::dvec3(0.9)), // a mirror
                       phong,
                       ofType(MaterialType::Dielectric, glm::dvec3(1.0)),
                       floor,
                       makeLamp(10.0),
                       makeLamp(30.0)};
    for (uint32_t i = 0; i < kBalls.size(); ++i)
        scene.shapes.push_back(makeBall(kBalls[i], i));
    scene.shapes.push_back(makeShape(Sphere{at({0.75, -0.6, 0.6}), 0.28}, 4));
    scene.shapes.push_back(makeShape(Sphere{at({-0.35, -0.7, 0.9}), 0.18}, 2));
    scene.shapes.push_back(makeShape(Cylinder{at({-1.1, -0.6, 0.4}), 0.15, 0.6}, 3));
    scene.shapes.push_back(makeRectangle({-3, -0.9, 3}, {6, 0, 0}, {0, 0, -6}, 5));
    scene.shapes.push_back(makeRectangle({-0.8, 2.5, 0.2}, {1.6, 0, 0}, {0, 0, 1.6}, 6));
    scene.shapes.push_back(makeShape(Sphere{at({-1.6, 1.2, 0.3}), 0.15}, 7));
    scene.shapes.push_back(makeShape(Sphere{at({1.6, 1.0, 0.6}), 0.1}, 7));
    return scene;
}

} // namespace calotype
