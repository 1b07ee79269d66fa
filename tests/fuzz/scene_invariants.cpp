#include "scene_invariants.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "base/check.h"

namespace calotype::fuzz {
namespace {

/// Of lengths and dot products of unit vectors: a few roundings in double.
constexpr double kUnitTolerance = 1e-9;

void checkFinite(double value) { CALOTYPE_CHECK_EQ(std::isfinite(value), true); }

template <typename Vector>
void checkFiniteVector(const Vector& v) {
    for (int i = 0; i < Vector::length(); ++i)
        checkFinite(v[i]);
}

void checkPositive(double value) {
    checkFinite(value);
    CALOTYPE_CHECK_LT(0.0, value);
}

void checkUnit(const glm::dvec3& v) {
    CALOTYPE_CHECK_LE(std::abs(glm::length(v) - 1.0), kUnitTolerance);
}

void checkOrthonormal(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
    for (const glm::dvec3& axis : {x, y, z})
        checkUnit(axis);
    for (const double cosine : {glm::dot(x, y), glm::dot(y, z), glm::dot(z, x)})
        CALOTYPE_CHECK_LE(std::abs(cosine), kUnitTolerance);
}

void checkCamera(const Camera& camera) {
    checkFiniteVector(camera.position);
    checkOrthonormal(camera.right, camera.up, camera.forward);
    checkPositive(camera.verticalFov);
    checkPositive(camera.viewHeight);
    checkPositive(camera.focusDistance);
    checkFinite(camera.lensRadius);
    CALOTYPE_CHECK_LE(0.0, camera.lensRadius);
}

void checkTexture(const Texture& texture) {
    if (const auto* image = std::get_if<ImageTexture>(&texture.source)) {
        const size_t samples = 4 * image->image->texelCount();
        CALOTYPE_CHECK_LT(0u, samples);
        CALOTYPE_CHECK_EQ(image->image->bytes.size() + image->image->floats.size(), samples);
    }
}

void checkMaterial(const Material& material, const Scene& scene) {
    checkFiniteVector(material.color);
    checkFiniteVector(material.emission);
    for (const double number : {material.roughness, material.specular, material.kd, material.ks,
                                material.exponent, material.opacity}) {
        checkFinite(number);
        CALOTYPE_CHECK_LE(0.0, number);
    }
    checkPositive(material.ior);
    checkPositive(material.exteriorIor);
    for (const uint32_t slot :
         {material.colorTexture, material.roughnessTexture, material.specularTexture,
          material.normalMap, material.alphaTexture})
        if (slot != Material::kNoTexture)
            CALOTYPE_CHECK_LT(slot, scene.textures.size());
}

void checkPlacement(const RigidTransform& transform) {
    checkFiniteVector(transform.translation);
    checkOrthonormal(transform.rotation[0], transform.rotation[1], transform.rotation[2]);
}

struct CheckGeometry {
    const Scene& scene;

    void operator()(const Sphere& sphere) const {
        checkPlacement(sphere.worldFromObject);
        checkPositive(sphere.radius);
    }
    void operator()(const Cylinder& cylinder) const {
        checkPlacement(cylinder.worldFromObject);
        checkPositive(cylinder.radius);
        checkPositive(cylinder.height);
    }
    void operator()(const Cone& cone) const {
        checkPlacement(cone.worldFromObject);
        checkPositive(std::abs(cone.height));
        checkPositive(cone.slope);
    }
    void operator()(const Disk& disk) const {
        checkPlacement(disk.worldFromObject);
        checkPositive(disk.radius);
    }
    void operator()(const Mesh& mesh) const {
        for (const glm::dvec3& position : mesh.positions)
            checkFiniteVector(position);
        for (const glm::dvec2& uv : mesh.uvs)
            checkFiniteVector(uv);
        CALOTYPE_CHECK_LT(0u, mesh.triangles.size());
        for (const Mesh::Triangle& triangle : mesh.triangles) {
            CALOTYPE_CHECK_LT(triangle.material, scene.materials.size());
            for (int k = 0; k < 3; ++k) {
                CALOTYPE_CHECK_LT(triangle.position[k], mesh.positions.size());
                CALOTYPE_CHECK_EQ(triangle.normal[k] == Mesh::kNoNormal,
                                  triangle.normal[0] == Mesh::kNoNormal);
                CALOTYPE_CHECK_EQ(triangle.uv[k] == Mesh::kNoUv, triangle.uv[0] == Mesh::kNoUv);
                if (triangle.normal[k] != Mesh::kNoNormal) {
                    CALOTYPE_CHECK_LT(triangle.normal[k], mesh.normals.size());
                    checkUnit(mesh.normals[triangle.normal[k]]);
                }
                if (triangle.uv[k] != Mesh::kNoUv)
                    CALOTYPE_CHECK_LT(triangle.uv[k], mesh.uvs.size());
            }
        }
    }
};

} // namespace

void checkScene(const Scene& scene) {
    checkCamera(scene.camera);
    checkFiniteVector(scene.background);
    for (const Texture& texture : scene.textures)
        checkTexture(texture);
    for (const Material& material : scene.materials)
        checkMaterial(material, scene);
    for (const Shape& shape : scene.shapes) {
        std::visit(CheckGeometry{scene}, shape.geometry);
        if (!std::holds_alternative<Mesh>(shape.geometry))
            CALOTYPE_CHECK_LT(shape.material, scene.materials.size());
    }
}

} // namespace calotype::fuzz
