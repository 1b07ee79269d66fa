#include <numbers>

#include <glm/geometric.hpp>

#include "gpu/kernels/test_structs.h"
#include "kernels/scattering.spv.h"
#include "support/gpu_test.h"
#include "support/random_numbers.h"
#include "support/statistics.h"

namespace calotype::test {
namespace {

constexpr uint32_t kEvents = 200'000;
const glm::vec4 kColor(0.8f, 0.5f, 0.25f, 0.0f);

/// A random event: the shading normal is off the geometric one by up to `bend`, and the viewer is
/// on either side.
gpu::TestScattering randomEvent(double bend, RandomNumbers& random) {
    const glm::dvec3 ng = random.direction();
    const glm::dvec3 ns = glm::normalize(ng + bend * random.inBall());
    gpu::TestScattering event{};
    event.ng = glm::vec3(ng);
    event.ns = glm::vec3(ns);
    event.wo = glm::vec3(random.direction());
    event.u1 = random.deviceUnit();
    event.u2 = random.deviceUnit();
    event.color = kColor;
    return event;
}

class Diffuse : public GpuTest {
protected:
    Diffuse() {
        RandomNumbers random(21);
        for (uint32_t i = 0; i < kEvents; ++i)
            events_.push_back(randomEvent(i % 2 == 0 ? 0.0 : 0.5, random));
        for (const float u : {0.0f, 1.0f - 0x1p-24f})
            for (const float v : {0.0f, 1.0f - 0x1p-24f}) {
                events_.push_back(randomEvent(0.0, random));
                events_.back().u1 = u;
                events_.back().u2 = v;
            }
        results_ = runKernel<gpu::TestScattered>(kScatteringSpirv, events_);
    }

    /// Cosine of a direction to a normal, turned to the viewer's side.
    static double cosine(const gpu::TestScattering& event, const glm::vec3& normal,
                         const glm::vec3& w) {
        const double facing = glm::dot(event.wo, event.ng) < 0.0f ? -1.0 : 1.0;
        return facing * glm::dot(glm::dvec3(normal), glm::dvec3(w));
    }

    std::vector<gpu::TestScattering> events_;
    std::vector<gpu::TestScattered> results_;
};

TEST_F(Diffuse, WeightIsValueOverDensity) {
    for (size_t i = 0; i < events_.size(); ++i) {
        const gpu::TestScattered& r = results_[i];
        ASSERT_GT(r.pdf, 0.0f);
        EXPECT_NEAR(r.pdfAgain, r.pdf, 3e-7);
        const double cosNs = cosine(events_[i], events_[i].ns, r.wi);
        const double cosNg = cosine(events_[i], events_[i].ng, r.wi);
        EXPECT_NEAR(r.pdf, cosNs / std::numbers::pi, 3e-7);
        for (int channel = 0; channel < 3; ++channel) {
            const double wanted = cosNg > 0.0 ? kColor[channel] : 0.0;
            if (std::abs(cosNg) > 1e-6) {
                EXPECT_FLOAT_EQ(r.weight[channel], static_cast<float>(wanted));
                EXPECT_NEAR(r.value[channel], r.weight[channel] * r.pdf, 1e-6);
            }
        }
    }
}

TEST_F(Diffuse, ReflectsTheSameBothWays) {
    for (size_t i = 0; i < events_.size(); i += 2) { // without shading normals
        const double cosIn = cosine(events_[i], events_[i].ng, results_[i].wi);
        const double cosOut = cosine(events_[i], events_[i].ng, events_[i].wo);
        if (std::min(cosIn, cosOut) > 1e-3) {
            EXPECT_NEAR(results_[i].value.x / cosIn / (results_[i].reversed.x / cosOut), 1.0, 1e-3);
        }
    }
}

TEST_F(Diffuse, DensityIntegratesToOne) {
    // The mean of g / pdf over samples is the integral of g over the hemisphere. g = 1 would have
    // an infinite variance (the density vanishes at the horizon), so g = min(1, 4 cos).
    std::vector<double> terms;
    for (const gpu::TestScattered& r : results_) {
        const double cosine = r.pdf * std::numbers::pi;
        terms.push_back(std::min(1.0, 4.0 * cosine) / r.pdf);
    }
    const Estimate integral = estimate(terms);
    // Over the hemisphere g integrates to 2 pi (1 - 1/8).
    EXPECT_NEAR(integral.mean, 2.0 * std::numbers::pi * 0.875, 4.0 * integral.standardError);
}

} // namespace
} // namespace calotype::test
