#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat3x4.hpp>

#include "kernels/frame.spv.h"
#include "support/gpu_test.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

class FrameTest : public GpuTest {};

TEST_F(FrameTest, IsARotationForEveryNormal) {
    std::vector<glm::vec4> normals;
    for (const float zero : {0.0f, -0.0f})
        for (const float one : {1.0f, -1.0f})
            normals.insert(normals.end(), {{one, zero, zero, 0},
                                           {zero, one, zero, 0},
                                           {zero, zero, one, 0},
                                           {zero, 0.6f * one, 0.8f, 0},
                                           {0.8f, 0.6f * one, zero, 0}});
    RandomNumbers random(3);
    for (uint32_t i = 0; i < 100'000; ++i) {
        glm::dvec3 n = random.direction();
        if (i % 2 == 0) // near the pole at which frames without care break down
            n = glm::normalize(glm::dvec3(n.x, n.y, 0.0) * random.powerOfTen(-9.0, 0.0) -
                               glm::dvec3(0.0, 0.0, 1.0));
        normals.push_back(glm::vec4(glm::vec3(n), 0.0f));
    }
    const auto frames = runKernel<glm::mat3x4>(kFrameSpirv, normals);
    double worst = 0.0;
    for (size_t i = 0; i < normals.size(); ++i) {
        const glm::dmat3 frame{glm::dvec3(frames[i][0]), glm::dvec3(frames[i][1]),
                               glm::dvec3(frames[i][2])};
        EXPECT_EQ(glm::vec3(frames[i][2]), glm::vec3(normals[i]));
        const glm::dmat3 product = glm::transpose(frame) * frame;
        for (int column = 0; column < 3; ++column)
            worst = std::max(worst, glm::length(product[column] - glm::dmat3(1.0)[column]));
        EXPECT_GT(glm::determinant(frame), 0.0);
    }
    RecordProperty("worstTimes1e9", std::to_string(worst * 1e9));
    EXPECT_LT(worst, 8.0 * 0x1p-23); // the normals themselves are unit to 2^-24 only
}

} // namespace
} // namespace calotype::test
