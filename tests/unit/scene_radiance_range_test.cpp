// Radiances that float does not hold are refused when a scene is read, for every engine alike.
#include "base/error.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

class RadianceRangeTest : public testing::Test {
protected:
    std::string errorOfEmission(double emission) {
        nlohmann::json scene =
            sceneWithShape(R"({"type": "sphere", "radius": 1, "material": "m"})");
        scene["materials"]["m"] = {{"type", "diffuse"}, {"color", 0.5}, {"emission", emission}};
        return errorOf(scene);
    }

    std::string errorOfBackground(double background) {
        nlohmann::json scene =
            sceneWithShape(R"({"type": "sphere", "radius": 1, "material": "wall"})");
        scene["background"] = background;
        return errorOf(scene);
    }

private:
    std::string errorOf(const nlohmann::json& scene) {
        try {
            files_.load(scene);
            return "";
        } catch (const SceneError& error) {
            return error.what();
        }
    }

    SceneFiles files_;
};

TEST_F(RadianceRangeTest, EndsWhereFloatLosesIt) {
    for (const double inside : {0.0, 1.1e-30, 1.0, 0.9e30}) {
        EXPECT_EQ(errorOfEmission(inside), "") << inside;
        EXPECT_EQ(errorOfBackground(inside), "") << inside;
    }
    for (const double outside : {1e-300, 0.9e-30, 1.1e30, 1e300}) {
        EXPECT_NE(errorOfEmission(outside).find("from 1e-30 to 1e30"), std::string::npos);
        EXPECT_NE(errorOfEmission(outside).find("\"m\""), std::string::npos);
        EXPECT_NE(errorOfBackground(outside).find("/background"), std::string::npos);
    }
}

} // namespace
} // namespace calotype::test
