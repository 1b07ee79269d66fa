// Specialising only removes code: for every feature alone, the kernel made for a scene that needs
// it and the kernel for everything render the same picture, bit for bit; and without the feature
// the picture is another.
#include <map>
#include <set>

#include "support/feature_cases.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

TEST(FeatureCasesTest, CoverEveryFeature) {
    std::set<uint32_t> covered;
    for (const FeatureCase& featureCase : featureCases())
        covered.insert(featureCase.feature);
    EXPECT_EQ(covered.size(), shared::kFeatureCount);
}

size_t differentPixels(const Image& a, const Image& b) {
    size_t count = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        count += a.pixels[i] == b.pixels[i] ? 0 : 1;
    return count;
}

class FeatureTest : public GpuTest, public testing::WithParamInterface<FeatureCase> {};

/// The feature's scene by the kernel made for it, rendered once for all tests of a process.
const RenderedScene& specialisedPicture(const FeatureCase& featureCase, const Scene& scene) {
    static std::map<uint32_t, RenderedScene> known;
    const auto at = known.find(featureCase.feature);
    return at != known.end() ? at->second
                             : known.emplace(featureCase.feature, renderScene(scene)).first->second;
}

TEST_P(FeatureTest, SpecialisedKernelEqualsEverythingOn) {
    SceneBuilder builder = litFloor();
    GetParam().change(builder);
    const RenderedScene& specialised = specialisedPicture(GetParam(), builder.scene());
    ASSERT_TRUE(specialised.needed.enabled[GetParam().feature]);
    RenderWish wish;
    wish.features = SceneFeatures::all();
    const RenderedScene everything = renderScene(builder.scene(), wish);
    ASSERT_NE(specialised.needed.enabled, wish.features->enabled);
    const auto& pixels = specialised.image.pixels;
    EXPECT_EQ(differentPixels(specialised.image, everything.image), 0u);
    const auto lit = std::ranges::count_if(pixels, [](const auto& p) { return p.x > 0.0f; });
    EXPECT_GT(static_cast<size_t>(lit), pixels.size() / 4);
}

// In a twentieth of the pixels: what the feature does is not lost in a corner.
TEST_P(FeatureTest, ChangesThePicture) {
    SceneBuilder builder = litFloor();
    GetParam().change(builder);
    const RenderedScene& with = specialisedPicture(GetParam(), builder.scene());
    RenderWish wish;
    if (GetParam().removal) {
        GetParam().removal(builder.scene());
    } else {
        wish.features = with.needed;
        wish.features->enabled[GetParam().feature] = false;
    }
    const RenderedScene without = renderScene(builder.scene(), wish);
    EXPECT_GT(differentPixels(with.image, without.image), with.image.pixels.size() / 20);
}

INSTANTIATE_TEST_SUITE_P(EveryOne, FeatureTest, testing::ValuesIn(featureCases()),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace calotype::test
