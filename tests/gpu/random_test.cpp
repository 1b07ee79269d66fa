#include <set>

#include "gpu/kernels/random_structs.h"
#include "kernels/random.spv.h"
#include "reference/random.h"
#include "support/chi_square.h"
#include "support/gpu_test.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

constexpr uint32_t kAllOnes = 0xFFFFFFFFu;

std::vector<shared::TestRandom> randoms(const std::vector<glm::uvec4>& words) {
    return runKernel<shared::TestRandom>(kRandomSpirv, words);
}

/// pcg4d, transcribed from Jarzynski and Olano 2020, listing of pcg4d.
glm::uvec4 transcribedPcg4d(glm::uvec4 v) {
    for (int i = 0; i < 4; ++i)
        v[i] = v[i] * 1664525u + 1013904223u;
    const auto mix = [&v] {
        v.x += v.y * v.w;
        v.y += v.z * v.x;
        v.z += v.x * v.y;
        v.w += v.y * v.z;
    };
    mix();
    for (int i = 0; i < 4; ++i)
        v[i] ^= v[i] >> 16u;
    mix();
    return v;
}

class RandomTest : public GpuTest {
protected:
    /// Counts of kCells^2 cells of pairs of numbers.
    static constexpr uint32_t kCells = 16;

    static void expectUniformPairs(const std::vector<std::pair<float, float>>& pairs,
                                   const std::string& what) {
        std::vector<uint64_t> counts(kCells * kCells);
        for (const auto& [x, y] : pairs)
            ++counts[uint32_t(x * kCells) * kCells + uint32_t(y * kCells)];
        const std::vector<double> chances(counts.size(), 1.0 / double(counts.size()));
        EXPECT_LT(chiSquare(counts, chances), chiSquareLimit(counts.size() - 1)) << what;
    }
};

TEST_F(RandomTest, HashIsThePublishedOne) {
    RandomNumbers random(1);
    std::vector<glm::uvec4> words = {glm::uvec4(0), glm::uvec4(kAllOnes), {1, 2, 3, 4}};
    for (int i = 0; i < 1000; ++i)
        words.push_back({random.bits(), random.bits(), random.bits(), random.bits()});
    const auto results = randoms(words);
    for (size_t i = 0; i < words.size(); ++i)
        EXPECT_EQ(results[i].hash, transcribedPcg4d(words[i]));
}

TEST_F(RandomTest, UnitFloatsStayBelowOne) {
    const auto results = randoms({glm::uvec4(kAllOnes), glm::uvec4(0xFF), glm::uvec4(0x100)});
    EXPECT_EQ(results[0].units, glm::vec4(1.0f - 0x1p-24f));
    EXPECT_EQ(results[1].units, glm::vec4(0.0f));
    EXPECT_EQ(results[2].units, glm::vec4(0x1p-24f));
}

TEST_F(RandomTest, NumbersAreUniformAndPairwiseIndependent) {
    // As a render draws them: neighbouring pixels, samples and dimensions.
    constexpr uint32_t kSamples = 1 << 18;
    std::vector<glm::uvec4> words;
    for (uint32_t dimension = 0; dimension < 4; ++dimension)
        for (uint32_t i = 0; i < kSamples / 4; ++i)
            words.push_back({i & 63u, (i >> 6u) & 63u, i >> 12u, dimension});
    const auto results = randoms(words);
    using Pairs = std::vector<std::pair<float, float>>;
    for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < a; ++b) {
            Pairs pairs;
            for (const auto& r : results)
                pairs.emplace_back(r.uniforms[a], r.uniforms[b]);
            expectUniformPairs(pairs, "components " + std::to_string(a) + std::to_string(b));
        }
        Pairs neighbours; // next pixel in x
        Pairs samples;    // next sample index
        Pairs dimensions; // next dimension
        for (size_t i = 0; i < results.size(); ++i) {
            const float x = results[i].uniforms[a];
            if (i % 2 == 0)
                neighbours.emplace_back(x, results[i + 1].uniforms[a]);
            if ((i >> 12u) % 2 == 0)
                samples.emplace_back(x, results[i + 4096].uniforms[a]);
            if (i < results.size() / 4)
                dimensions.emplace_back(x, results[i + results.size() / 4].uniforms[a]);
        }
        expectUniformPairs(neighbours, "neighbouring pixels, component " + std::to_string(a));
        expectUniformPairs(samples, "successive samples, component " + std::to_string(a));
        expectUniformPairs(dimensions, "successive dimensions, component " + std::to_string(a));
    }
}

TEST_F(RandomTest, NoDimensionIsUsedTwice) {
    constexpr uint32_t kBounces = 1000;
    std::vector<glm::uvec4> words;
    for (uint32_t bounce = 0; bounce < kBounces; ++bounce)
        words.push_back({bounce, 0, 0, 0});
    const auto results = randoms(words);
    std::set<uint32_t> seen;
    for (const auto& r : results) {
        for (int i = 0; i < 4; ++i)
            seen.insert(r.bounceDimensions[i]);
        for (int i = 0; i < 4; ++i)
            seen.insert(r.otherDimensions[i]);
    }
    EXPECT_EQ(seen.size(), 5 * kBounces + 3);
}

// The device multiplies by Pascal's triangle in five steps; the reference adds direction numbers.
TEST_F(RandomTest, SobolPointsAreTheReferences) {
    RandomNumbers random(9);
    std::vector<glm::uvec4> words;
    for (int i = 0; i < 4000; ++i) {
        const uint32_t sample = random.bits() >> random.below(32);
        words.push_back({random.bits() >> 16, random.bits() >> 16, sample, 8 * random.below(9)});
    }
    const auto results = randoms(words);
    for (size_t i = 0; i < words.size(); ++i) {
        const glm::uvec4& w = words[i];
        const reference::SampleId id{{w.x, w.y}, w.z, 7, Sampler::Sobol};
        const glm::dvec4 expected =
            w.w == 0 ? reference::cameraNumbers(id)
                     : reference::bounceNumbers(id, w.w / 8 - 1, reference::BounceDimension::Light);
        EXPECT_EQ(glm::dvec4(results[i].sobol), expected) << "sample " << w.z;
    }
}

} // namespace
} // namespace calotype::test
