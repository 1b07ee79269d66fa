// First hits of the device against those of the reference tracer, pixel by pixel.
#include <algorithm>
#include <iostream>

#include <glm/geometric.hpp>

#include "engine/compile_scene.h"
#include "image/judged_scenes.h"
#include "render/first_hit_pass.h"
#include "render/reference_first_hits.h"
#include "scene/scene_bounds.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

FirstHitImage deviceFirstHits(const Scene& scene, RenderSettings settings) {
    settings.bvh = BvhBuilder::Sah;
    const GpuScene packed = compileScene(scene, settings, {.allUvs = true}).packed;
    const SceneBuffers buffers(testDevice(), packed);
    return FirstHitPass(testDevice(), packed, buffers, packed.features, settings).run();
}

class FirstHitAgreementTest : public GpuTest, public testing::WithParamInterface<JudgedScene> {
protected:
    static constexpr uint32_t kSide = 128;

    FirstHitAgreementTest() : scene_(projectScene(GetParam().path)) {
        settings_.width = kSide;
        settings_.height = kSide;
        settings_.crop = {0, 0, kSide, kSide};
    }

    /// True where the reference finds the primitive within a thousandth of a pixel: the pixel's
    /// centre lies on its outline, and rounding decides.
    bool isAtOutline(const reference::ReferenceTracer& tracer, uint32_t x, uint32_t y,
                     uint32_t primitive) const {
        for (int k = 0; k < 8; ++k) {
            const double angle = 0.785398 * k;
            const glm::dvec2 aside(std::cos(angle), std::sin(angle));
            const glm::dvec2 nearby = glm::dvec2(x + 0.5, y + 0.5) + 1e-3 * aside;
            if (tracer.firstHitAt(nearby).primitive == primitive)
                return true;
        }
        return false;
    }

    Scene scene_;
    RenderSettings settings_;
};

/// The largest differences of two pictures' hits, where both show the same primitive.
struct Differences {
    double position = 0.0; ///< over the distance
    double depth = 0.0;    ///< likewise
    double normal = 0.0;
    double uv = 0.0;
    double albedo = 0.0;

    void add(const FirstHit& a, const FirstHit& b) {
        const auto grow = [](double& most, float value) {
            EXPECT_TRUE(std::isfinite(value)); // a maximum would hide a NaN
            most = std::max<double>(most, value);
        };
        grow(position, glm::distance(a.position, b.position) / a.depth);
        grow(depth, std::abs(a.depth - b.depth) / a.depth);
        grow(normal, glm::distance(a.normal, b.normal));
        grow(uv, glm::distance(a.uv, b.uv));
        grow(albedo, glm::distance(a.albedo, b.albedo));
    }
};

// Bounds: a direction of single precision is off by some 1e-7, which a surface seen at a slant
// stretches along the ray, tenfold at most here. Smooth normals and texture coordinates turn it
// into as much as they change over a shape that is small against its distance; images turn an error
// of uv into one of their value, by as much as the hundreds of texels of ours differ.
TEST_P(FirstHitAgreementTest, EqualButForPixelsOnOutlines) {
    const reference::ReferenceTracer tracer(scene_, {kSide, kSide}, 0);
    const FirstHitImage expected = referenceFirstHits(tracer, settings_, 2);
    const FirstHitImage found = deviceFirstHits(scene_, settings_);
    size_t exceptions = 0;
    Differences most;
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const FirstHit& a = expected.at(x, y);
            const FirstHit& b = found.at(x, y);
            if (a.primitive != b.primitive) {
                ++exceptions;
                EXPECT_TRUE(isAtOutline(tracer, x, y, b.primitive))
                    << x << "," << y << ": " << b.primitive << " instead of " << a.primitive;
            } else if (a.primitive != kNoPrimitive) {
                most.add(a, b);
            }
        }
    const bool hasNormalMaps = std::ranges::any_of(scene_.materials, [](const Material& material) {
        return material.normalMap != Material::kNoTexture;
    });
    const bool hasImages = std::ranges::any_of(scene_.textures, [](const Texture& texture) {
        return std::holds_alternative<ImageTexture>(texture.source);
    });
    EXPECT_LT(exceptions, kSide * kSide / 100);
    EXPECT_LT(most.position, 3e-6);
    EXPECT_LT(most.depth, 3e-6);
    EXPECT_LT(most.uv, 5e-5);
    EXPECT_LT(most.normal, hasNormalMaps ? 3e-3 : 1e-4);
    EXPECT_LT(most.albedo, hasImages ? 1e-3 : 1e-7);
    std::cout << exceptions << " on outlines; differences of position " << most.position
              << ", depth " << most.depth << ", normal " << most.normal << ", uv " << most.uv
              << ", albedo " << most.albedo << "\n";
}

INSTANTIATE_TEST_SUITE_P(Scenes, FirstHitAgreementTest, testing::ValuesIn(kJudgedScenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

} // namespace
} // namespace calotype::test
