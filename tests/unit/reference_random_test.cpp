// Sobol's points, as the reference draws them: each uniform, together even, and independent between
// uses, replicas, pixels and seeds.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "reference/random.h"
#include "support/chi_square.h"

namespace calotype::test {
namespace {

using reference::BounceDimension;
using reference::SampleId;

SampleId sobolSample(uint32_t sample, uint32_t seed = 5, const glm::uvec2& pixel = {3, 8}) {
    return {pixel, sample, seed, Sampler::Sobol};
}

/// Whether each of the 2^k boxes of every shape that 2^k boxes of the same shape tile the square
/// with holds one point.
void expectOneInEachInterval(const std::vector<glm::dvec2>& points) {
    const auto count = static_cast<uint32_t>(points.size());
    for (uint32_t columns = 1; columns <= count; columns *= 2) {
        std::set<std::pair<uint32_t, uint32_t>> boxes;
        for (const glm::dvec2& point : points)
            boxes.insert({uint32_t(point.x * columns), uint32_t(point.y * (count / columns))});
        EXPECT_EQ(boxes.size(), count) << columns << " columns";
    }
}

TEST(ReferenceSobolTest, FirstPointsOfABlockHaveEachIntervalToThemselves) {
    for (const uint32_t block : {0u, 1u, 9u, 70000u}) {
        for (const uint32_t count : {2u, 4u, 8u, 16u}) {
            std::vector<glm::dvec2> film, lens, light, direction;
            for (uint32_t i = 0; i < count; ++i) {
                const SampleId id = sobolSample(16 * block + i);
                const glm::dvec4 camera = cameraNumbers(id);
                film.emplace_back(camera.x, camera.y);
                lens.emplace_back(camera.z, camera.w);
                const glm::dvec4 onLight = bounceNumbers(id, 2, BounceDimension::Light);
                light.emplace_back(onLight.z, onLight.w);
                const glm::dvec4 scattered = bounceNumbers(id, 2, BounceDimension::Bsdf);
                direction.emplace_back(scattered.x, scattered.y);
            }
            for (const auto& points : {film, lens, light, direction})
                expectOneInEachInterval(points);
        }
    }
}

TEST(ReferenceSobolTest, BlocksOfAReplicaGoOnWhereItsLastEnded) {
    std::vector<glm::dvec2> points;
    for (uint32_t block = 3; block < 8 * 16; block += 8)
        for (uint32_t i = 0; i < 16; ++i)
            points.emplace_back(cameraNumbers(sobolSample(16 * block + i)));
    expectOneInEachInterval(points);
}

/// Pairs of numbers over many seeds lie anywhere with the same chance.
void expectIndependent(const std::string& what,
                       const std::function<std::pair<double, double>(uint32_t seed)>& draw) {
    constexpr uint32_t kCells = 16;
    std::vector<uint64_t> counts(kCells * kCells);
    for (uint32_t seed = 0; seed < 40000; ++seed) {
        const auto [x, y] = draw(seed);
        ++counts[uint32_t(x * kCells) * kCells + uint32_t(y * kCells)];
    }
    const std::vector<double> chances(counts.size(), 1.0 / double(counts.size()));
    EXPECT_LT(chiSquare(counts, chances), chiSquareLimit(counts.size() - 1)) << what;
}

TEST(ReferenceSobolTest, EachPointIsUniformAndUsesAreIndependent) {
    const auto at = [](uint32_t sample, uint32_t seed) {
        return cameraNumbers(sobolSample(sample, seed));
    };
    for (const uint32_t sample : {0u, 5u, 4711u})
        expectIndependent("one point", [&](uint32_t seed) {
            return std::pair(at(sample, seed).x, at(sample, seed).y);
        });
    expectIndependent("film and lens",
                      [&](uint32_t seed) { return std::pair(at(5, seed).x, at(5, seed).z); });
    expectIndependent("film and direction", [&](uint32_t seed) {
        return std::pair(at(5, seed).x,
                         bounceNumbers(sobolSample(5, seed), 0, BounceDimension::Bsdf).x);
    });
    expectIndependent("replicas",
                      [&](uint32_t seed) { return std::pair(at(5, seed).x, at(16 + 5, seed).x); });
    expectIndependent("pixels", [&](uint32_t seed) {
        return std::pair(at(5, seed).x, cameraNumbers(sobolSample(5, seed, {4, 8})).x);
    });
    expectIndependent("seeds", [&](uint32_t seed) {
        return std::pair(at(5, 2 * seed).x, at(5, 2 * seed + 1).x);
    });
}

} // namespace
} // namespace calotype::test
