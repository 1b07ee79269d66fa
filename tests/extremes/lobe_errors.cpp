#include "extremes/lobe_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include <glm/geometric.hpp>

#include "kernels/scattering.spv.h"
#include "reference/bsdf.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/oracle_bsdf.h"
#include "support/test_materials.h"

namespace calotype::test {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

glm::dvec3 anyView(RandomNumbers& random) {
    return directionAt(random.powerOfTen(-6.0, 0.0), kTwoPi * random.unit());
}

/// Unit again after rounding to float.
glm::dvec3 unit(const glm::vec3& v) { return glm::normalize(glm::dvec3(v)); }

bool isFinite(const shared::TestScattered& r) {
    return std::isfinite(r.wi.x + r.wi.y + r.wi.z + r.pdf) &&
           std::isfinite(r.weight.x + r.weight.y + r.weight.z + r.pdfAgain) &&
           std::isfinite(r.value.x + r.value.y + r.value.z) &&
           std::isfinite(r.given.x + r.given.y + r.given.z + r.givenPdf);
}

std::string describe(const Material& material, const shared::TestScattering& event) {
    std::ostringstream text;
    text.precision(9);
    const auto put = [&](const char* name, const glm::vec3& v) {
        text << ", " << name << " (" << v.x << ", " << v.y << ", " << v.z << ")";
    };
    text << "roughness " << material.roughness << ", exponent " << material.exponent;
    put("wo", event.wo);
    put("wi", event.wi);
    put("ng", event.ng);
    put("u", {event.u1, event.u2, event.u3});
    return text.str();
}

/// The logarithm of the lobe's height at a half vector of some tangent, over that at the normal.
double logLobe(const Material& material, double tangent) {
    const double log1pTan2 = std::log1p(tangent * tangent);
    if (material.type == MaterialType::BlinnPhong)
        return -0.5 * material.exponent * log1pTan2;
    const double alpha = material.roughness * material.roughness;
    const double t = 1.0 + std::pow(tangent / alpha, 2);
    return 2.0 * log1pTan2 - 2.0 * std::log(t);
}

struct Band {
    double lower;
    double upper;
    bool contains(double x) const { return lower <= x && x <= upper; }
};

/// By what factors a lobe's value and density may be off.
Band allowedFactors(const Material& material, const glm::dvec3& wo, const glm::dvec3& wi,
                    double roundoffs) {
    const glm::dvec3 sum = wo + wi;
    const double turn = roundoffs * kRoundoffOfFloat;
    const double turnOfHalf = turn / glm::length(sum);
    const double tangent = std::hypot(sum.x, sum.y) / sum.z;
    const double slack = turnOfHalf * (1.0 + tangent * tangent);
    const double height = logLobe(material, tangent);
    const double nearer = logLobe(material, std::max(0.0, tangent - slack)) - height;
    const double farther = logLobe(material, tangent + slack) - height;
    // Cosines of either direction, once each, and that to the half vector twice, for Fresnel's
    // powers; an exponential is off by its argument's roundings.
    const double factor = (1.0 + turn / wo.z) * (1.0 + turn / wi.z) *
                          std::pow(1.0 + turnOfHalf, 2) * std::exp(turn * (1.0 + std::abs(height)));
    return {std::exp(farther) / factor, std::exp(nearer) * factor};
}

/// Pairs of directions where the lobe is: half vectors spread over eight of its widths.
std::vector<shared::TestScattering> eventsAcross(const Material& material, double lobeWidth,
                                                 size_t count, RandomNumbers& random) {
    std::vector<shared::TestScattering> events;
    while (events.size() < count) {
        const glm::dvec3 wo = anyView(random);
        const double tangent = lobeWidth * random.between(0.0, 8.0);
        const glm::dvec3 h =
            directionAt(1.0 / std::sqrt(1.0 + tangent * tangent), kTwoPi * random.unit());
        const glm::dvec3 wi = 2.0 * glm::dot(wo, h) * h - wo;
        if (glm::dot(wo, h) <= 0.0 || wi.z < 1e-6)
            continue;
        events.push_back(scatteringOn(material, wo));
        events.back().wi = glm::vec3(wi);
    }
    return events;
}

double neededRoundoffs(const Material& material, const shared::TestScattering& event,
                       const shared::TestScattered& answer) {
    constexpr double kNegligible = 1e-30; // of a value or a density: where floats underflow
    const glm::dvec3 wo = unit(event.wo);
    const glm::dvec3 wi = unit(event.wi);
    const glm::dvec3 value = oracleValue(material, wo, wi);
    const double chance = answer.diffuseProbability;
    const double pdf = chance * wi.z / std::numbers::pi +
                       (1.0 - chance) * (chance < 1.0 ? oracleHalfVectorPdf(material, wo, wi) : 0);
    const auto isWithin = [&](double found, double wanted, const Band& band) {
        return std::max(std::abs(found), wanted) < kNegligible || band.contains(found / wanted);
    };
    double roundoffs = 0.5;
    for (; roundoffs < 0x1p30; roundoffs *= 2.0) {
        const Band band = allowedFactors(material, wo, wi, roundoffs);
        if (isWithin(answer.given.x, value.x, band) && isWithin(answer.givenPdf, pdf, band))
            break;
    }
    return roundoffs;
}

/// One end of the numbers' range or the other, now and then.
float numberOrEnd(RandomNumbers& random) {
    constexpr float kLargest = 1.0f - 0x1p-24f;
    const uint32_t kind = random.below(16);
    return kind == 0 ? 0.0f : kind == 1 ? kLargest : random.deviceUnit();
}

std::vector<shared::TestScattering> eventsAnywhere(const Material& material, SurfaceFrame frame,
                                                   size_t count, RandomNumbers& random) {
    std::vector<shared::TestScattering> events;
    for (size_t i = 0; i < count; ++i) {
        shared::TestScattering event = scatteringOn(material, anyView(random));
        if (frame == SurfaceFrame::Turned) {
            const glm::dvec3 ng = random.direction();
            const glm::dvec3 tangent = glm::normalize(glm::cross(ng, random.direction()));
            event.ng = event.ns = glm::vec3(ng);
            event.wo = glm::vec3(double(event.wo.z) * ng +
                                 std::sqrt(1.0 - std::pow(event.wo.z, 2)) * tangent);
        }
        event.u1 = numberOrEnd(random);
        event.u2 = numberOrEnd(random);
        event.u3 = numberOrEnd(random);
        events.push_back(event);
    }
    return events;
}

reference::Bsdf referenceBsdf(const Material& material, const shared::TestScattering& event) {
    reference::Surface surface{};
    surface.ng = surface.ns = surface.horizon = unit(event.ng);
    return {material, {}, surface, unit(event.wo)};
}

/// The weight that the direction of `scattered` should have.
double weightAt(const reference::Bsdf& bsdf, const reference::Bsdf::Sample& scattered,
                const glm::dvec3& wi) {
    if (std::isinf(scattered.pdf))
        return scattered.weight.x;
    const reference::Bsdf::Value there = bsdf.evaluate(wi);
    return there.pdf > 0.0 ? there.value.x / there.pdf : 0.0;
}

/// Whether two samples of a view go the same way, if they go anywhere: to a tenth of the lobe's
/// width and of how far they are from the mirror's direction.
bool agree(const shared::TestScattering& event, double lobeWidth,
           const shared::TestScattered& answer, const reference::Bsdf::Sample& wanted) {
    const bool leaves = answer.weight.x > 0.0f;
    const glm::dvec3 mirrored = glm::reflect(-unit(event.wo), unit(event.ng));
    const double near = 0.1 * (lobeWidth + glm::distance(wanted.wi, mirrored));
    return leaves == (wanted.weight.x > 0.0) &&
           (!leaves || glm::distance(glm::dvec3(answer.wi), wanted.wi) < near);
}

/// Whether the reference agrees with the answer for some view and numbers near the event's.
bool isExplainedByRounding(const Material& material, double lobeWidth,
                           const shared::TestScattering& event, const shared::TestScattered& answer,
                           RandomNumbers& random) {
    constexpr int kTries = 1000;
    constexpr double kNear = 8.0 * kRoundoffOfFloat;
    const auto near = [&](float u) {
        return std::clamp(u + kNear * random.between(-1.0, 1.0), 0.0, 1.0);
    };
    for (int i = 0; i < kTries; ++i) {
        reference::Surface surface{};
        surface.ng = surface.ns = surface.horizon = unit(event.ng);
        const glm::dvec3 wo = glm::normalize(unit(event.wo) + kNear * random.direction());
        const reference::Bsdf bsdf(material, {}, surface, wo);
        const reference::Bsdf::Sample wanted =
            bsdf.sample({near(event.u1), near(event.u2), near(event.u3)});
        if (agree(event, lobeWidth, answer, wanted))
            return true;
        const glm::dvec3 wi = glm::normalize(wanted.wi + kNear * random.direction());
        const bool underflows =
            std::isfinite(wanted.pdf) && bsdf.evaluate(wi).pdf < std::numeric_limits<float>::min();
        if (answer.weight.x == 0.0f && underflows)
            return true;
    }
    return false;
}

/// To roundings of the directions.
double sensitivity(const glm::dvec3& ng, const glm::dvec3& wo, const glm::dvec3& wi,
                   double lobeWidth) {
    return 1.0 / std::abs(glm::dot(wo, ng)) + 1.0 / std::abs(glm::dot(wi, ng)) +
           1.0 / (lobeWidth * glm::length(wo + wi));
}

/// To roundings of the chance of one of two lobes; none where there is one only.
double sensitivity(double chance) {
    const double smaller = std::min(chance, 1.0 - chance);
    return smaller > 0.0 ? 1.0 / smaller : 0.0;
}

} // namespace

void addValues(const Material& material, double lobeWidth, size_t count, RandomNumbers& random,
               LobeErrors& errors) {
    const auto events = eventsAcross(material, lobeWidth, count, random);
    const auto answers = runKernel<shared::TestScattered>(kScatteringSpirv, events);
    errors.events += events.size();
    for (size_t i = 0; i < events.size(); ++i) {
        errors.notFinite += isFinite(answers[i]) ? 0 : 1;
        const double needed = neededRoundoffs(material, events[i], answers[i]);
        if (needed > errors.roundoffs) {
            errors.roundoffs = needed;
            errors.worst = describe(material, events[i]);
        }
    }
}

void addSamples(const Material& material, double lobeWidth, SurfaceFrame frame, size_t count,
                RandomNumbers& random, LobeErrors& errors) {
    constexpr double kResolved = 1e-3;
    const auto events = eventsAnywhere(material, frame, count, random);
    const auto answers = runKernel<shared::TestScattered>(kScatteringSpirv, events);
    errors.events += events.size();
    double difference = 0.0;
    for (size_t i = 0; i < events.size(); ++i) {
        errors.notFinite += isFinite(answers[i]) ? 0 : 1;
        const reference::Bsdf bsdf = referenceBsdf(material, events[i]);
        const reference::Bsdf::Sample wanted =
            bsdf.sample({events[i].u1, events[i].u2, events[i].u3});
        const double weight = answers[i].weight.x;
        errors.greatestWeight = std::max(errors.greatestWeight, weight);
        const glm::dvec3 wo = unit(events[i].wo);
        const glm::dvec3 wi(answers[i].wi);
        if (!agree(events[i], lobeWidth, answers[i], wanted)) {
            ++errors.tipped;
            if (!isExplainedByRounding(material, lobeWidth, events[i], answers[i], random)) {
                ++errors.unexplained;
                errors.worst = describe(material, events[i]);
            }
            continue;
        }
        if (weight == 0.0)
            continue;
        const double slack = kRoundoffOfFloat * std::max(1.0, wanted.weight.x) *
                             (sensitivity(unit(events[i].ng), wo, wi, lobeWidth) +
                              sensitivity(answers[i].diffuseProbability));
        const double off = weight - weightAt(bsdf, wanted, unit(answers[i].wi));
        difference += slack < kResolved ? weight - wanted.weight.x : 0.0;
        if (std::abs(off) / slack > errors.roundoffs) {
            errors.roundoffs = std::abs(off) / slack;
            errors.worst = describe(material, events[i]);
        }
    }
    errors.meanDifference =
        std::max(errors.meanDifference, std::abs(difference) / static_cast<double>(events.size()));
}

std::ostream& operator<<(std::ostream& out, const LobeErrors& errors) {
    return out << errors.events << " events, roundoffs " << errors.roundoffs << ", greatest weight "
               << errors.greatestWeight << ", tipped " << errors.tipped << " ("
               << errors.unexplained << " unexplained), mean off by " << errors.meanDifference
               << "\n";
}

} // namespace calotype::test
