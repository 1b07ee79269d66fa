// Mirrors and smooth dielectrics: directions that are certain.
#include <cmath>

#include <glm/geometric.hpp>

#include "kernels/scattering.spv.h"
#include "shared/limits.h"
#include "support/gpu_test.h"
#include "support/oracle_bsdf.h"
#include "support/random_numbers.h"
#include "support/statistics.h"
#include "support/test_materials.h"

namespace calotype::test {
namespace {

constexpr uint32_t kSamples = 40'000;

std::vector<shared::TestScattered> drawSamples(shared::TestScattering event,
                                               RandomNumbers& random) {
    std::vector<shared::TestScattering> events(kSamples, event);
    for (shared::TestScattering& e : events) {
        e.u1 = random.deviceUnit();
        e.u2 = random.deviceUnit();
        e.u3 = random.deviceUnit();
    }
    return runKernel<shared::TestScattered>(kScatteringSpirv, events);
}

glm::dvec3 mirrored(const glm::dvec3& w) { return {-w.x, -w.y, w.z}; }

double meanWeight(const std::vector<shared::TestScattered>& samples) {
    double sum = 0.0;
    for (const shared::TestScattered& sample : samples)
        sum += sample.weight.x;
    return sum / static_cast<double>(samples.size());
}

Material metal(double roughness, Masking masking) {
    Material material;
    material.type = MaterialType::Metal;
    material.color = {0.9, 0.7, 0.5};
    material.roughness = roughness;
    material.masking = masking;
    return material;
}

class SpecularTest : public GpuTest {};

// Seen from outside and from within: which side it is, the true surface alone decides.
TEST_F(SpecularTest, DielectricFollowsSnellAndFresnel) {
    RandomNumbers random(91);
    Material glass;
    glass.type = MaterialType::Dielectric;
    glass.color = {0.9, 0.8, 0.7};
    for (const double ior : {1.0, 1.0 + 1e-6, 1.5, 1.0 / 1.5, 4.0})
        for (const double side : {1.0, -1.0})
            for (const double cosThetaI : {1.0, 0.9, 0.7, 0.5, 0.1, 1e-3}) {
                glass.ior = ior;
                const double eta = side > 0.0 ? ior : 1.0 / ior;
                glm::dvec3 wo = directionAt(cosThetaI, 0.4);
                wo.z *= side;
                uint32_t reflected = 0;
                for (const shared::TestScattered& s :
                     drawSamples(scatteringOn(glass, wo), random)) {
                    const glm::dvec3 wi(s.wi);
                    ASSERT_EQ(s.crosses != 0, wi.z * side < 0.0);
                    if (s.crosses == 0) {
                        ++reflected;
                        ASSERT_LT(glm::distance(wi, mirrored(wo)), 1e-6);
                        ASSERT_EQ(s.weight, glm::vec3(1.0f));
                        continue;
                    }
                    ASSERT_NEAR(glm::length(wi), 1.0, 1e-6);
                    ASSERT_NEAR(wi.x * eta, -wo.x, 1e-6) << ior;
                    ASSERT_NEAR(wi.y * eta, -wo.y, 1e-6) << ior;
                    for (int channel = 0; channel < 3; ++channel)
                        ASSERT_NEAR(s.weight[channel], glass.color[channel] / (eta * eta),
                                    2e-6 * glass.color[channel] / (eta * eta));
                }
                const double wanted = oracleFresnel(cosThetaI, eta);
                const double share = static_cast<double>(reflected) / kSamples;
                EXPECT_NEAR(share, wanted,
                            4.0 * std::sqrt(wanted * (1.0 - wanted) / kSamples) + 1e-4)
                    << "index " << ior << ", side " << side << ", cosine " << cosThetaI;
            }
}

TEST_F(SpecularTest, MetalOfNoRoughnessIsAMirror) {
    RandomNumbers random(92);
    const double almostMirror = 0.999 * std::sqrt(shared::kMirrorAlpha);
    for (const double roughness : {0.0, almostMirror})
        for (const Masking masking : {Masking::Schlick, Masking::Smith})
            for (const double cosThetaO : {1.0, 0.5, 0.05}) {
                const Material material = metal(roughness, masking);
                const glm::dvec3 wo = directionAt(cosThetaO, 2.0);
                const double k = std::pow(roughness + 1.0, 2) / 8.0;
                const double g1 =
                    masking == Masking::Smith ? 1.0 : cosThetaO / (cosThetaO * (1.0 - k) + k);
                const double fresnel = 0.9 + 0.1 * std::pow(1.0 - cosThetaO, 5);
                for (const shared::TestScattered& s :
                     drawSamples(scatteringOn(material, wo), random)) {
                    ASSERT_LT(glm::distance(glm::dvec3(s.wi), mirrored(wo)), 1e-6);
                    ASSERT_NEAR(s.weight.x, fresnel * g1 * g1, 1e-6);
                    ASSERT_GT(s.pdf, 1e20f);
                }
            }
}

// Just above the threshold the lobe is narrow and reflects as much as the mirror just below.
TEST_F(SpecularTest, MirrorIsTheLimitOfLittleRoughness) {
    RandomNumbers random(93);
    const double threshold = std::sqrt(shared::kMirrorAlpha);
    for (const Masking masking : {Masking::Schlick, Masking::Smith})
        for (const double cosThetaO : {1.0, 0.5, 0.1}) {
            const glm::dvec3 wo = directionAt(cosThetaO, 2.0);
            const auto draw = [&](double roughness) {
                return drawSamples(scatteringOn(metal(roughness, masking), wo), random);
            };
            const auto below = draw(0.999 * threshold);
            const auto above = draw(1.001 * threshold);
            EXPECT_NEAR(meanWeight(above), meanWeight(below), 1e-3 * meanWeight(below))
                << "cosine " << cosThetaO;
            size_t near = 0;
            for (const shared::TestScattered& s : above) {
                ASSERT_LT(s.pdf, 1e20f);
                near += glm::distance(glm::dvec3(s.wi), mirrored(wo)) < 20.0 * shared::kMirrorAlpha;
            }
            // A GGX lobe has 1 / 101 of its half vectors beyond a tangent of ten alpha.
            EXPECT_GT(near, kSamples * 97 / 100) << "cosine " << cosThetaO;
        }
}

// The mirror over a diffuse base: both lobes' shares come out, whatever the chance of each.
TEST_F(SpecularTest, NonmetalOfNoRoughnessMixesMirrorAndDiffuse) {
    RandomNumbers random(94);
    Material varnish;
    varnish.type = MaterialType::Nonmetal;
    varnish.color = glm::dvec3(0.5);
    for (const double cosThetaO : {1.0, 0.4, 0.1}) {
        const double k = 0.125;
        const double g1 = cosThetaO / (cosThetaO * (1.0 - k) + k);
        const double fresnel = 0.04 + 0.96 * std::pow(1.0 - cosThetaO, 5);
        std::vector<double> mirrorWeights, diffuseWeights;
        for (const shared::TestScattered& s :
             drawSamples(scatteringOn(varnish, directionAt(cosThetaO, 1.0)), random)) {
            const bool specular = s.pdf > 1e20f;
            mirrorWeights.push_back(specular ? s.weight.x : 0.0);
            diffuseWeights.push_back(specular ? 0.0 : s.weight.x);
        }
        const Estimate mirror = estimate(mirrorWeights);
        const Estimate diffuse = estimate(diffuseWeights);
        EXPECT_NEAR(mirror.mean, fresnel * g1 * g1, 4.0 * mirror.standardError) << cosThetaO;
        EXPECT_NEAR(diffuse.mean, 0.96 * 0.5, 4.0 * diffuse.standardError) << cosThetaO;
    }
}

// Whatever the shading normal: the viewer sees the shaded side, the mirrored direction leaves on
// the true surface's side, and the refracted one on the other.
TEST_F(SpecularTest, DirectionsAgreeWithTheTrueSurface) {
    RandomNumbers random(95);
    std::vector<shared::TestScattering> events;
    Material glass;
    glass.type = MaterialType::Dielectric;
    glass.color = glm::dvec3(1.0);
    const Material chrome = metal(0.0, Masking::Smith);
    for (int i = 0; i < 100'000; ++i) {
        const glm::dvec3 ng = random.direction();
        glm::dvec3 ns = random.direction();
        ns = glm::dot(ns, ng) < 0.0 ? -ns : ns;
        glm::dvec3 wo = random.direction();
        if (i % 4 == 0) // grazing
            wo = glm::normalize(wo - (1.0 - random.powerOfTen(-6.0, -1.0)) * glm::dot(wo, ng) * ng);
        shared::TestScattering event = scatteringOn(i % 2 == 0 ? glass : chrome, wo);
        event.ng = glm::vec3(ng);
        event.ns = glm::vec3(ns);
        event.u3 = random.deviceUnit();
        events.push_back(event);
    }
    const auto results = runKernel<shared::TestScattered>(kScatteringSpirv, events);
    for (size_t i = 0; i < events.size(); ++i) {
        const double facing = glm::dot(glm::dvec3(events[i].wo), glm::dvec3(events[i].ng));
        const double leaving = glm::dot(glm::dvec3(results[i].wi), glm::dvec3(events[i].ng));
        if (std::abs(facing) < 1e-6) // rounding decides which side it is
            continue;
        const double side = facing < 0.0 ? -1.0 : 1.0;
        ASSERT_TRUE(std::isfinite(leaving));
        ASSERT_NEAR(glm::length(results[i].wi), 1.0f, 1e-5f);
        ASSERT_GT(glm::dot(glm::dvec3(events[i].wo), glm::dvec3(results[i].ns)), -1e-6);
        if (results[i].crosses != 0)
            ASSERT_LE(side * leaving, 1e-7);
        else
            ASSERT_GE(side * leaving, -1e-7);
    }
}

// Where the shading normal needs no help it stays as it is.
TEST_F(SpecularTest, NormalsInAgreementAreKept) {
    const Material chrome = metal(0.0, Masking::Smith);
    shared::TestScattering event = scatteringOn(chrome, directionAt(0.8, 0.0));
    event.ns = glm::vec3(glm::normalize(glm::dvec3(0.2, 0.1, 1.0)));
    const auto results = runKernel<shared::TestScattered>(
        kScatteringSpirv, std::vector<shared::TestScattering>{event});
    EXPECT_EQ(results[0].ns, event.ns);
}

} // namespace
} // namespace calotype::test
