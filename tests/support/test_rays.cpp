#include "support/test_rays.h"

#include <glm/geometric.hpp>

#include "support/oracle_quadric.h"
#include "support/test_quadrics.h"

namespace calotype::test {
namespace {

class RayAimer {
public:
    RayAimer(const shared::Quadric& quadric, RandomNumbers& random)
        : quadric_(quadric), random_(random), size_(static_cast<double>(reachOf(quadric))),
          axes_{glm::dvec3(quadric.axisX), glm::dvec3(quadric.axisY), glm::dvec3(quadric.axisZ)} {}

    AimedRay aim(RayKind kind) {
        switch (kind) {
        case RayKind::Outside:
            return towards(nearby(), distance(0.3, 1.0));
        case RayKind::Far:
            return towards(nearby(), distance(1.0, 3.0));
        case RayKind::Inside:
            return {inside(), random_.direction()};
        case RayKind::Grazing:
            return grazing();
        case RayKind::WorldAxis:
            return along(worldAxis());
        case RayKind::LocalAxis:
            return along(random_.sign() * axes_[random_.below(3)]);
        case RayKind::NearlyLocalAxis:
            return along(axes_[1] + random_.powerOfTen(-20.0, -6.0) * axes_[0]);
        case RayKind::Apex:
            return towards(world({}), distance(-1.0, 1.0));
        case RayKind::SideLine:
            return along(random_.sign() * (axes_[1] + double(quadric_.slope) * axes_[0]));
        case RayKind::Rim:
            return random_.coin() ? towards(rim(), distance(0.0, 2.0)) : fromTo(inside(), rim());
        case RayKind::FacePlane:
            return inFacePlane();
        case RayKind::OnSurface:
            return {world(randomSurfacePoint(quadric_, random_).position), random_.direction()};
        }
        return {};
    }

private:
    glm::dvec3 world(const glm::dvec3& local) const { return worldPoint(quadric_, local); }

    double distance(double lowerPower, double upperPower) {
        return size_ * random_.powerOfTen(lowerPower, upperPower);
    }

    glm::dvec3 nearby() { return world(localMiddle(quadric_)) + 0.8 * size_ * random_.inBall(); }

    glm::dvec3 inside() {
        const glm::dvec3 p = randomSurfacePoint(quadric_, random_).position;
        return world(glm::mix(localMiddle(quadric_), p, random_.unit()));
    }

    glm::dvec3 rim() {
        const glm::dvec3 around = random_.direction();
        const glm::dvec2 unit = glm::normalize(glm::dvec2(around.x, around.z));
        const double radius = quadric_.radius;
        return world({radius * unit.x, faceHeight(quadric_, random_), radius * unit.y});
    }

    /// Rounds both ends first, so that the ray really passes through the target.
    AimedRay fromTo(const glm::dvec3& from, const glm::dvec3& to) const {
        const glm::vec3 origin(from);
        return {glm::dvec3(origin), glm::dvec3(glm::vec3(to) - origin)};
    }

    AimedRay towards(const glm::dvec3& target, double distance) {
        return fromTo(target + distance * random_.direction(), target);
    }

    AimedRay along(const glm::dvec3& direction) {
        return {nearby() - random_.between(-0.5, 10.0) * size_ * direction, direction};
    }

    glm::dvec3 worldAxis() {
        glm::dvec3 axis(random_.coin() ? 0.0 : -0.0, random_.coin() ? 0.0 : -0.0,
                        random_.coin() ? 0.0 : -0.0);
        axis[static_cast<int>(random_.below(3))] = random_.sign();
        return axis;
    }

    AimedRay grazing() {
        const LocalPoint point = randomSurfacePoint(quadric_, random_);
        const glm::dvec3 tangent = glm::normalize(glm::cross(point.normal, random_.direction()));
        const double height = random_.sign() * distance(-9.0, -2.0);
        return fromTo(world(point.position + height * point.normal - distance(-0.3, 1.0) * tangent),
                      world(point.position + height * point.normal));
    }

    AimedRay inFacePlane() {
        const double y = faceHeight(quadric_, random_);
        const glm::dvec3 around = random_.direction();
        const glm::dvec3 towardsAxis(-around.x, 0.0, -around.z);
        const glm::dvec3 from = 2.0 * size_ * glm::dvec3(around.x, 0.0, around.z);
        return {world(from + glm::dvec3(0.0, y, 0.0)), world(towardsAxis) - world({})};
    }

    const shared::Quadric& quadric_;
    RandomNumbers& random_;
    double size_;
    glm::dvec3 axes_[3];
};

} // namespace

std::string nameOf(RayKind kind) {
    constexpr const char* kNames[] = {
        "FromOutside",    "FromFar",      "FromInside",         "Grazing",
        "AlongWorldAxis", "AlongOwnAxis", "NearlyAlongOwnAxis", "AtApex",
        "AlongSideLine",  "AtRim",        "InFacePlane",        "FromSurface"};
    return kNames[static_cast<int>(kind)];
}

AimedRay aimRay(RayKind kind, const shared::Quadric& quadric, RandomNumbers& random) {
    AimedRay ray = RayAimer(quadric, random).aim(kind);
    if (random.coin())
        ray.direction *= random.powerOfTen(-3.0, 3.0) / glm::length(ray.direction);
    return ray;
}

} // namespace calotype::test
