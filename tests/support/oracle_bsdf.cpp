#include "support/oracle_bsdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace calotype::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Angle between the half vector and the normal: by atan2, which loses nothing near zero.
double halfAngle(const glm::dvec3& wo, const glm::dvec3& wi) {
    const glm::dvec3 h = wo + wi;
    return std::atan2(std::hypot(h.x, h.y), h.z);
}

double cosToHalf(const glm::dvec3& wo, const glm::dvec3& wi) {
    return glm::dot(wo, glm::normalize(wo + wi));
}

/// Eq. 1.28, with (n.h)^2 (a^2 - 1) + 1 as a^2 cos^2 + sin^2.
double ggxD(double angle, double alpha) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double t = alpha * alpha * c * c + s * s;
    return alpha * alpha / (kPi * t * t);
}

/// Eq. 1.29.
double schlick(double f0, double cosTheta) { return f0 + (1.0 - f0) * std::pow(1.0 - cosTheta, 5); }

/// Smith's Lambda for GGX (Heitz 2014, eq. 72).
double lambda(double cosTheta, double alpha) {
    const double tan2 = (1.0 - cosTheta * cosTheta) / (cosTheta * cosTheta);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2) - 1.0);
}

double maskingAndShadowing(const Material& material, double cosO, double cosI) {
    const double alpha = material.roughness * material.roughness;
    if (material.masking == Masking::Smith)
        return 1.0 / (1.0 + lambda(cosO, alpha) + lambda(cosI, alpha));
    const double k = std::pow(material.roughness + 1.0, 2) / 8.0;
    const auto g1 = [k](double c) { return c / (c * (1.0 - k) + k); };
    return g1(cosO) * g1(cosI);
}

double cookTorrance(const Material& material, double f0, const glm::dvec3& wo,
                    const glm::dvec3& wi) {
    const double alpha = material.roughness * material.roughness;
    return ggxD(halfAngle(wo, wi), alpha) * schlick(f0, cosToHalf(wo, wi)) *
           maskingAndShadowing(material, wo.z, wi.z) / (4.0 * wo.z * wi.z);
}

double cosPower(double angle, double exponent) {
    return std::exp(0.5 * exponent * std::log1p(-std::pow(std::sin(angle), 2)));
}

double blinnPhong(const Material& material, const glm::dvec3& wo, const glm::dvec3& wi) {
    const double n = material.exponent;
    const double lobe = cosPower(halfAngle(wo, wi), n) / (2.0 * kPi);
    if (material.normalize)
        return material.ks * (n + 1.0) * lobe / (4.0 * cosToHalf(wo, wi) * std::max(wo.z, wi.z));
    return material.ks * (n + 2.0) * lobe;
}

} // namespace

glm::dvec3 oracleValue(const Material& material, const glm::dvec3& wo, const glm::dvec3& wi) {
    glm::dvec3 f(0.0);
    switch (material.type) {
    case MaterialType::Diffuse:
        f = material.color / kPi;
        break;
    case MaterialType::Metal:
        for (int channel = 0; channel < 3; ++channel)
            f[channel] = cookTorrance(material, material.color[channel], wo, wi);
        break;
    case MaterialType::Nonmetal:
        f = glm::dvec3(cookTorrance(material, material.specular, wo, wi)) +
            (1.0 - material.specular) * material.color / kPi;
        break;
    case MaterialType::BlinnPhong:
        f = material.kd * material.color / kPi + blinnPhong(material, wo, wi);
        break;
    case MaterialType::Dielectric:
        break;
    }
    return f * wi.z;
}

double oracleHalfVectorPdf(const Material& material, const glm::dvec3& wo, const glm::dvec3& wi) {
    const double jacobian = 1.0 / (4.0 * cosToHalf(wo, wi));
    const double angle = halfAngle(wo, wi);
    if (material.type == MaterialType::BlinnPhong)
        return (material.exponent + 1.0) / (2.0 * kPi) * cosPower(angle, material.exponent) *
               jacobian;
    const double alpha = material.roughness * material.roughness;
    const double g1 = 1.0 / (1.0 + lambda(wo.z, alpha));
    return g1 * cosToHalf(wo, wi) * ggxD(angle, alpha) / wo.z * jacobian;
}

double oracleFresnel(double cosThetaI, double eta) {
    const double thetaI = std::acos(cosThetaI);
    const double sinThetaT = std::sin(thetaI) / eta;
    if (sinThetaT >= 1.0)
        return 1.0;
    if (thetaI == 0.0)
        return std::pow((eta - 1.0) / (eta + 1.0), 2);
    const double thetaT = std::asin(sinThetaT);
    const double perpendicular = std::sin(thetaI - thetaT) / std::sin(thetaI + thetaT);
    const double parallel = std::tan(thetaI - thetaT) / std::tan(thetaI + thetaT);
    return 0.5 * (perpendicular * perpendicular + parallel * parallel);
}

} // namespace calotype::test
