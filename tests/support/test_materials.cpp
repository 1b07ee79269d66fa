#include "support/test_materials.h"

#include <algorithm>
#include <cmath>

#include "pack/pack_material.h"

namespace calotype::test {
namespace {

TestMaterial ggx(MaterialType type, double roughness, Masking masking) {
    TestMaterial test;
    Material& material = test.material;
    material.type = type;
    material.roughness = roughness;
    material.masking = masking;
    const bool metal = type == MaterialType::Metal;
    material.color = metal ? glm::dvec3(1.0, 0.78, 0.34) : glm::dvec3(0.6, 0.4, 0.2);
    test.name = std::string(metal ? "metal" : "nonmetal") + " of roughness " +
                std::to_string(roughness) + (masking == Masking::Smith ? ", smith" : "");
    test.conservesEnergy = metal;
    test.lobeWidth = roughness * roughness;
    return test;
}

TestMaterial blinnPhong(double exponent, double kd, double ks, bool normalize) {
    TestMaterial test;
    Material& material = test.material;
    material.type = MaterialType::BlinnPhong;
    material.color = {0.9, 0.6, 0.3};
    material.exponent = exponent;
    material.kd = kd;
    material.ks = ks;
    material.normalize = normalize;
    test.name = "Blinn-Phong of exponent " + std::to_string(exponent) + ", kd " +
                std::to_string(kd) + (normalize ? ", normalized" : "");
    test.conservesEnergy = normalize || kd + 4.0 * ks <= 1.0;
    test.lobeWidth = std::min(1.0, std::sqrt(2.0 / (exponent + 2.0)));
    return test;
}

} // namespace

std::vector<TestMaterial> testMaterials() {
    std::vector<TestMaterial> tests(1);
    tests[0].name = "diffuse";
    tests[0].material.color = {0.8, 0.5, 0.25};
    for (const double roughness : {0.02, 0.1, 0.3, 0.6, 1.0})
        for (const Masking masking : {Masking::Schlick, Masking::Smith}) {
            tests.push_back(ggx(MaterialType::Metal, roughness, masking));
            tests.push_back(ggx(MaterialType::Nonmetal, roughness, masking));
        }
    for (const double exponent : {0.0, 1.0, 20.0, 1000.0, 1e5})
        for (const bool normalize : {false, true}) {
            tests.push_back(blinnPhong(exponent, 0.5, 0.4, normalize));
            tests.push_back(blinnPhong(exponent, 0.0, 0.9, normalize));
        }
    tests.push_back(blinnPhong(200.0, 0.9, 0.02, false));
    return tests;
}

shared::TestScattering scatteringOn(const Material& material, const glm::dvec3& wo) {
    SceneFeatures ignored;
    TexturePacker noTextures({});
    shared::TestScattering event{};
    event.ng = event.ns = glm::vec3(0.0f, 0.0f, 1.0f);
    event.wo = glm::vec3(wo);
    event.wi = glm::vec3(0.0f, 0.0f, 1.0f);
    event.material = packMaterial(material, {}, noTextures, ignored);
    return event;
}

glm::dvec3 directionAt(double cosTheta, double phi) {
    const double sinTheta = std::sqrt((1.0 - cosTheta) * (1.0 + cosTheta));
    return {sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta};
}

} // namespace calotype::test
