#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "scene/scene.h"

namespace calotype::test {

/// Makes scenes in code, for tests whose answer is known.
class SceneBuilder {
public:
    SceneBuilder() {
        scene_.film = {16, 16};
        scene_.render = {16, 0, 0};
    }

    uint32_t material(Material material) {
        scene_.materials.push_back(std::move(material));
        return static_cast<uint32_t>(scene_.materials.size() - 1);
    }

    uint32_t material(double albedo, double emission, bool frontOnly = false) {
        Material material;
        material.color = glm::dvec3(albedo);
        material.emission = glm::dvec3(emission);
        material.emitsFromFrontOnly = frontOnly;
        return this->material(material);
    }

    uint32_t texture(Texture texture) {
        scene_.textures.push_back(std::move(texture));
        return static_cast<uint32_t>(scene_.textures.size() - 1);
    }

    /// A texture of one colour.
    uint32_t constantTexture(const glm::dvec3& color) {
        return texture({"constant", CheckerTexture{{color, color}}});
    }

    SceneBuilder& add(Shape shape) {
        scene_.shapes.push_back(std::move(shape));
        return *this;
    }

    /// A convex polygon as a fan of triangles.
    SceneBuilder& polygon(const std::vector<glm::dvec3>& corners, uint32_t material) {
        Mesh mesh;
        mesh.positions = corners;
        for (uint32_t i = 2; i < corners.size(); ++i)
            mesh.triangles.push_back(
                {{0, i - 1, i}, {Mesh::kNoNormal, Mesh::kNoNormal, Mesh::kNoNormal}, material});
        Shape shape;
        shape.geometry = std::move(mesh);
        return add(std::move(shape));
    }

    /// The rectangle from `corner` along two edges, with texture coordinates from (0, 0) there to
    /// (1, 1), or from (1, 0) to (0, 1) where they are mirrored.
    SceneBuilder& rectangle(const glm::dvec3& corner, const glm::dvec3& edgeU,
                            const glm::dvec3& edgeV, uint32_t material, bool mirroredU = false) {
        Mesh mesh;
        mesh.positions = {corner, corner + edgeU, corner + edgeU + edgeV, corner + edgeV};
        mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (glm::dvec2& uv : mesh.uvs)
            uv.x = mirroredU ? 1.0 - uv.x : uv.x;
        constexpr uint32_t kNo = Mesh::kNoNormal;
        mesh.triangles = {{{0, 1, 2}, {kNo, kNo, kNo}, material, {0, 1, 2}},
                          {{0, 2, 3}, {kNo, kNo, kNo}, material, {0, 2, 3}}};
        Shape shape;
        shape.geometry = std::move(mesh);
        return add(std::move(shape));
    }

    /// Parallel rays along -z onto the square of `side` metres about the origin; x is right, y up.
    SceneBuilder& lookAtPlaneZ(double side) {
        scene_.camera = {};
        scene_.camera.projection = Projection::Orthographic;
        scene_.camera.position = {0.0, 0.0, 5.0};
        scene_.camera.viewHeight = side;
        return *this;
    }

    /// Looks straight down from `height` above the origin, at a square of `side` metres on the
    /// plane y = 0.
    SceneBuilder& lookDown(double height, double side) {
        scene_.camera.position = {0.0, height, 0.0};
        scene_.camera.forward = {0.0, -1.0, 0.0};
        scene_.camera.up = {0.0, 0.0, -1.0};
        scene_.camera.right = {1.0, 0.0, 0.0};
        scene_.camera.verticalFov = 2.0 * std::atan2(0.5 * side, height);
        return *this;
    }

    Scene& scene() { return scene_; }

private:
    Scene scene_;
};

template <typename Geometry>
Shape makeShape(Geometry geometry, uint32_t material) {
    Shape shape;
    shape.geometry = std::move(geometry);
    shape.material = material;
    return shape;
}

} // namespace calotype::test
