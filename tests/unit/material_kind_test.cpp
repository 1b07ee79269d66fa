// The list of materials: its order, its names and the lobes that each kind is packed into.
#include <set>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "materials/material_kind.h"

namespace calotype::test {
namespace {

Material ofType(MaterialType type) {
    Material material;
    material.type = type;
    material.color = glm::dvec3(0.5);
    return material;
}

TEST(MaterialKindTest, ListIsInTheOrderOfTheTypes) {
    EXPECT_EQ(kindOf(ofType(MaterialType::Diffuse)).name, "diffuse");
    EXPECT_EQ(kindOf(ofType(MaterialType::Metal)).name, "metal");
    EXPECT_EQ(kindOf(ofType(MaterialType::Nonmetal)).name, "nonmetal");
    EXPECT_EQ(kindOf(ofType(MaterialType::BlinnPhong)).name, "blinn_phong");
    EXPECT_EQ(kindOf(ofType(MaterialType::Dielectric)).name, "dielectric");
    EXPECT_EQ(materialKinds().size(), 5u);
}

TEST(MaterialKindTest, PacksItsLobes) {
    const auto lobesOf = [](const Material& material) {
        shared::Material packed{};
        kindOf(material).pack(material, packed);
        return packed.lobes;
    };
    EXPECT_EQ(lobesOf(ofType(MaterialType::Diffuse)), shared::kLobeDiffuse);
    EXPECT_EQ(lobesOf(Material()), 0u) << "a black diffuse surface";
    EXPECT_EQ(lobesOf(ofType(MaterialType::Metal)), shared::kLobeGgx | shared::kColorIsF0);
    EXPECT_EQ(lobesOf(ofType(MaterialType::Nonmetal)), shared::kLobeGgx | shared::kLobeDiffuse);
    EXPECT_EQ(lobesOf(ofType(MaterialType::BlinnPhong)),
              shared::kLobeBlinnPhong | shared::kLobeDiffuse);
    EXPECT_EQ(lobesOf(ofType(MaterialType::Dielectric)),
              shared::kLobeDielectric | shared::kColorIsTint);
    Material smith = ofType(MaterialType::Metal);
    smith.masking = Masking::Smith;
    EXPECT_EQ(lobesOf(smith), shared::kLobeGgx | shared::kColorIsF0 | shared::kSmithMasking);
    Material normalized = ofType(MaterialType::BlinnPhong);
    normalized.normalize = true;
    EXPECT_NE(lobesOf(normalized) & shared::kNormalizedLobe, 0u);
}

TEST(MaterialKindTest, ParametersHaveNamesAndDescriptionsOfTheirOwn) {
    for (const MaterialKind& kind : materialKinds()) {
        EXPECT_FALSE(kind.description.empty()) << kind.name;
        std::set<std::string> names;
        for (const MaterialParameter& parameter : kind.parameters) {
            EXPECT_TRUE(names.insert(parameter.name).second) << kind.name << parameter.name;
            EXPECT_FALSE(parameter.description.empty()) << kind.name << parameter.name;
        }
        EXPECT_EQ(kind.excessAlbedo == nullptr, kind.excessWarning == nullptr) << kind.name;
    }
}

TEST(MaterialKindTest, DefaultsLieInTheirRanges) {
    for (const MaterialKind& kind : materialKinds()) {
        for (const MaterialParameter& parameter : kind.parameters) {
            const auto* number = std::get_if<NumberParameter>(&parameter.value);
            if (number != nullptr && parameter.otherwise)
                EXPECT_TRUE(number->range.contains(*parameter.otherwise)) << parameter.name;
            if (std::holds_alternative<FlagParameter>(parameter.value) ||
                std::holds_alternative<ChoiceParameter>(parameter.value)) {
                EXPECT_TRUE(parameter.otherwise) << parameter.name << " needs a default";
            }
        }
    }
}

} // namespace
} // namespace calotype::test
