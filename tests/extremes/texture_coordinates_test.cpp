// Texture coordinates far from 0: how far from its place a texel is found, and up to where all of
// an image's texels are.
#include <cmath>
#include <iostream>
#include <set>

#include "check/texture_precision.h"
#include "kernels/coordinates.spv.h"
#include "pack/pack_shapes.h"
#include "render/scene_buffers.h"
#include "support/gpu_test.h"
#include "support/oracle_texture.h"
#include "support/packed_textures.h"
#include "support/primitive_scene.h"

namespace calotype::test {
namespace {

/// A square whose coordinates go from `start` to `start` + 1 each way, as rays from above see it.
class FarSquare {
public:
    explicit FarSquare(double start) : start_(start) {
        const auto u0 = static_cast<float>(start);
        const auto u1 = static_cast<float>(start + 1.0);
        scene_.triangles = {packTriangle({0, 0, 0}, {1, 0, 0}, {1, 1, 0}),
                            packTriangle({0, 0, 0}, {1, 1, 0}, {0, 1, 0})};
        scene_.triangleUvs = {{{u0, u0}, {u1, u0}, {u1, u1}, 0, 0},
                              {{u0, u0}, {u1, u1}, {u0, u1}, 0, 0}};
    }

    /// What the device finds at points (x, y) of the square, and what it should.
    struct Found {
        glm::dvec2 uv;
        glm::dvec2 exact;
    };
    std::vector<Found> find(const std::vector<glm::dvec2>& points) const {
        std::vector<shared::TestRay> rays;
        for (const glm::dvec2& p : points)
            rays.push_back(testRay({p, 1.0}, {0.0, 0.0, -1.0}, p.x >= p.y ? 0 : 1));
        const PrimitiveScene scene(scene_);
        const SceneBuffers buffers(testDevice(), scene.packed());
        const auto results = runKernel<shared::TestCoordinates>(
            kCoordinatesSpirv, rays, buffers.bindings(), kTestInputBinding);
        std::vector<Found> found;
        for (size_t i = 0; i < rays.size(); ++i)
            found.push_back(
                {{results[i].u, results[i].v}, start_ + glm::dvec2(glm::vec2(rays[i].origin))});
        return found;
    }

private:
    double start_;
    GpuScene scene_;
};

std::vector<glm::dvec2> randomPoints(size_t count, uint64_t seed) {
    RandomNumbers random(seed);
    std::vector<glm::dvec2> points(count);
    for (glm::dvec2& p : points)
        p = {random.between(0.001, 0.999), random.between(0.001, 0.999)};
    return points;
}

class FarTexturesTest : public GpuTest {};

// To nearest, half a rounding each: the corners, the weight that is a difference (twice), the
// products and two sums: three. One more where a device rounds otherwise.
TEST_F(FarTexturesTest, CoordinatesAreOffByFourRoundingsAtMost) {
    const auto points = randomPoints(20'000, 251);
    for (const double start : {0.0, 1e3, 1e6, -1e6, 1e9}) {
        double worst = 0.0;
        for (const FarSquare::Found& found : FarSquare(start).find(points))
            for (int axis = 0; axis < 2; ++axis)
                worst = std::max(worst, std::abs(found.uv[axis] - found.exact[axis]));
        const double roundings = worst / (kRoundoffOfFloat * (std::abs(start) + 1.0));
        std::cout << "from " << start << ": off by " << worst << ", " << roundings
                  << " roundings\n";
        EXPECT_LE(roundings, 4.0);
    }
}

// Coordinates that float holds are wrapped without a loss, however far away.
TEST_F(FarTexturesTest, LookUpsOfExactCoordinatesAreExact) {
    RandomNumbers random(252);
    const PackedTextures packed(variedTextures(
        {{16, 16, true, true}, {5, 3, true, true}, {256, 64, false, false}}, random));
    std::vector<shared::TestTextureRead> reads;
    for (uint32_t index = 0; index < packed.textures().size(); ++index)
        for (int i = 0; i < 3000; ++i) {
            // A third about powers of two, beyond which float has one digit less.
            const double power = std::exp2(10 + random.below(10));
            const double away = i % 3 == 0 ? 1e6 : i % 3 == 1 ? power : power * random.unit();
            const double far = random.sign() * away;
            reads.push_back({glm::vec2{far + random.unit(), -far + random.unit()}, index, 0});
        }
    const auto colors = packed.read(reads);
    double worst = 0.0;
    for (size_t i = 0; i < reads.size(); ++i) {
        const Texture& texture = packed.textures()[reads[i].index];
        const TexelImage& image = imageOf(texture);
        const glm::dvec2 uv(reads[i].uv);
        const glm::dvec2 cell = uv * glm::dvec2(image.width, image.height);
        const glm::dvec2 toBorder = glm::abs(cell - glm::round(cell));
        // A size that is no power of two, times a coordinate, may be rounded across a border.
        if (std::get<ImageTexture>(texture.source).filter == TextureFilter::Nearest &&
            std::min(toBorder.x, toBorder.y) < 256.0 * 2.0 * kRoundoffOfFloat)
            continue;
        const glm::dvec4 wanted = oracleTexture(texture, uv, false);
        for (int channel = 0; channel < 4; ++channel)
            worst = std::max(worst, std::abs(colors[i][channel] - wanted[channel]));
    }
    std::cout << "colors up to 20 off by " << worst << "\n";
    // Two roundings of a position in up to 256 texels, between texels that differ by up to 20.
    EXPECT_LE(worst, 20.0 * 256.0 * 2.0 * kRoundoffOfFloat);
}

/// How many of n texels in a row are ever found by coordinates from `start` on.
size_t texelsFound(double start, uint32_t n) {
    std::vector<glm::dvec2> points;
    for (uint32_t i = 0; i < 8 * n; ++i)
        points.push_back({(i + 0.5) / (8.0 * n), 0.0});
    std::set<int64_t> seen;
    for (const FarSquare::Found& found : FarSquare(start).find(points))
        seen.insert(static_cast<int64_t>(std::floor((found.uv.x - start) * n)));
    return seen.size();
}

// The limit that `calotype info` warns of: up to it no texel is lost, and each is found half a
// texel from its place at most; sixteen times farther, half of them are lost.
TEST_F(FarTexturesTest, TexelsAreFoundUpToTheLimit) {
    constexpr uint32_t kTexels = 1024;
    const auto points = randomPoints(20'000, 253);
    for (double far = 0x1p16; far <= 0x1p26; far *= 4.0) {
        const double start = far / kTexels;
        double worst = 0.0;
        for (const FarSquare::Found& found : FarSquare(start).find(points))
            worst = std::max(worst, std::abs(found.uv.x - found.exact.x) * kTexels);
        const size_t seen = texelsFound(start, kTexels);
        std::cout << far << " texels away: off by " << worst << " texels, " << seen << " of "
                  << kTexels << " found\n";
        if (far <= kFarthestTexel) {
            EXPECT_LE(worst, 0.5);
            EXPECT_GE(seen, kTexels);
        }
        if (far >= 16.0 * kFarthestTexel)
            EXPECT_LE(seen, kTexels / 2 + 1);
    }
}

} // namespace
} // namespace calotype::test
