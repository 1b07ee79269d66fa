// Texture coordinates at hits, and the directions in which they grow, against the scene format's
// words in double.
#include <cmath>

#include <glm/geometric.hpp>

#include "gpu/primitive_scene.h"
#include "kernels/coordinates.spv.h"
#include "render/scene_buffers.h"
#include "support/gpu_test.h"
#include "support/oracle_coordinates.h"
#include "support/test_quadrics.h"

namespace calotype::test {
namespace {

constexpr double kRoundoffOfFloat = 0x1p-23;
/// That angleInTurns states; the angle of v counts twice.
constexpr double kAngleError = 1e-7;

std::vector<gpu::TestCoordinates> coordinatesAt(const PrimitiveScene& scene,
                                                const std::vector<gpu::TestRay>& rays) {
    const SceneBuffers buffers(testDevice(), scene.packed());
    return runKernel<gpu::TestCoordinates>(kCoordinatesSpirv, rays, buffers.bindings(),
                                           kTestInputBinding);
}

/// The distance between two numbers of a circle of length 1.
double aroundCircle(double a, double b) {
    const double difference = std::abs(a - b);
    return std::min(difference, 1.0 - difference);
}

glm::dvec3 unit(const glm::vec3& v) { return glm::normalize(glm::dvec3(v)); }

/// That texture coordinates do along a direction of the surface what dpdu promises of u: it grows,
/// the other one stays. `slope` is the derivative of (u, v) per unit of length along a direction.
template <typename Slope>
void expectGrowth(const gpu::TestCoordinates& at, const Slope& slope, double tolerance) {
    const glm::dvec2 alongU = slope(unit(at.dpdu));
    const glm::dvec2 alongV = slope(unit(at.dpdv));
    EXPECT_GT(alongU.x, 0.0);
    EXPECT_GT(alongV.y, 0.0);
    EXPECT_NEAR(alongU.y / alongV.y, 0.0, tolerance);
    EXPECT_NEAR(alongV.x / alongU.x, 0.0, tolerance);
}

/// A quadric near the origin, at some scale, upright or turned, of any proportion.
std::vector<gpu::Quadric> nearbyQuadrics(uint32_t kind, RandomNumbers& random) {
    std::vector<gpu::Quadric> quadrics = variedQuadrics(kind, random);
    for (gpu::Quadric& quadric : quadrics)
        quadric.center = glm::vec3(random.inBall() * double(quadric.radius));
    return quadrics;
}

double sizeOf(const gpu::Quadric& quadric) { return quadric.radius + std::abs(quadric.extent); }

/// Rays that meet each quadric from about its size away, steeply.
std::vector<gpu::TestRay> raysOnto(const std::vector<gpu::Quadric>& quadrics, int raysEach,
                                   RandomNumbers& random) {
    std::vector<gpu::TestRay> rays;
    for (uint32_t i = 0; i < quadrics.size(); ++i)
        for (int k = 0; k < raysEach; ++k) {
            const LocalPoint point = randomSurfacePoint(quadrics[i], random);
            const glm::dvec3 outward =
                sizeOf(quadrics[i]) * glm::normalize(point.normal + 0.7 * random.inBall());
            const glm::dvec3 target = worldPoint(quadrics[i], point.position);
            const glm::dvec3 origin = worldPoint(quadrics[i], point.position + outward);
            rays.push_back(testRay(origin, glm::normalize(target - origin), i | gpu::kQuadricBit));
        }
    return rays;
}

class QuadricCoordinates : public GpuTest, public testing::WithParamInterface<uint32_t> {
protected:
    /// Calls check(quadric, isOnFlatFace, hit, point, error) for every hit that clearly lies on one
    /// face: `point` is the hit in the quadric's frame, `error` bounds how far off it may be: 16
    /// roundings of the distances in play, as for hits.
    template <typename Check>
    void forEachHit(const Check& check) {
        RandomNumbers random(111);
        const auto quadrics = nearbyQuadrics(GetParam(), random);
        const auto rays = raysOnto(quadrics, 400, random);
        const auto results = coordinatesAt(PrimitiveScene::ofQuadrics(quadrics), rays);
        size_t checked = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const gpu::Quadric& quadric = quadrics[rays[i].primitive & ~gpu::kQuadricBit];
            const glm::dvec3 point = localPoint(quadric, glm::dvec3(results[i].position));
            const double error = 16.0 * kRoundoffOfFloat * 3.0 * sizeOf(quadric);
            const NearestFace face = nearestFace(quadric, point);
            if (face.margin < 4.0 * error)
                continue;
            ++checked;
            check(quadric, face.isFlat, results[i], point, error);
            if (HasFailure())
                return;
        }
        EXPECT_GT(checked, rays.size() * 9 / 10);
    }
};

TEST_P(QuadricCoordinates, AreTheFormats) {
    forEachHit([](const gpu::Quadric& quadric, bool isFlat, const gpu::TestCoordinates& hit,
                  const glm::dvec3& point, double error) {
        const glm::dvec2 wanted = oracleCoordinates(quadric, isFlat, point);
        const double radius = std::hypot(point.x, point.z);
        const double scaleOfV = quadric.kind == gpu::kSphere ? quadric.radius
                                : isFlat                     ? 2.0 * quadric.radius
                                                             : std::abs(quadric.extent);
        const double errorU = kAngleError + error / (isFlat ? 2.0 * quadric.radius : radius);
        ASSERT_NEAR(isFlat ? std::abs(hit.u - wanted.x) : aroundCircle(hit.u, wanted.x), 0.0,
                    errorU);
        ASSERT_NEAR(hit.v, wanted.y, 2.0 * kAngleError + error / scaleOfV);
        if (!isFlat) {
            ASSERT_GE(hit.u, 0.0f);
            ASSERT_LT(hit.u, 1.0f);
        }
    });
}

TEST_P(QuadricCoordinates, GrowAlongTheirDirections) {
    forEachHit([](const gpu::Quadric& quadric, bool isFlat, const gpu::TestCoordinates& hit,
                  const glm::dvec3& point, double error) {
        const double radius = std::hypot(point.x, point.z);
        if (!isFlat && radius < 1e-3 * quadric.radius)
            return; // towards a pole or an apex u has no direction
        const double step = 1e-5 * std::min(radius, sizeOf(quadric));
        const auto slope = [&](const glm::dvec3& world) {
            const glm::dvec3 local = localPoint(quadric, glm::dvec3(quadric.center) + world);
            const glm::dvec2 ahead = oracleCoordinates(quadric, isFlat, point + step * local);
            const glm::dvec2 behind = oracleCoordinates(quadric, isFlat, point - step * local);
            glm::dvec2 difference = ahead - behind;
            difference.x -= std::round(difference.x); // across the seam
            return difference / (2.0 * step);
        };
        const double turned = isFlat ? 0.0 : error / radius;
        expectGrowth(hit, slope, 16.0 * kRoundoffOfFloat + 4.0 * turned + 1e-9);
    });
}

TEST_P(QuadricCoordinates, GrowAlongTheSurface) {
    forEachHit([](const gpu::Quadric& quadric, bool isFlat, const gpu::TestCoordinates& hit,
                  const glm::dvec3& point, double error) {
        const double radius = std::hypot(point.x, point.z);
        glm::dvec3 normal(0.0, 1.0, 0.0);
        if (!isFlat && quadric.kind == gpu::kSphere)
            normal = glm::normalize(point);
        if (!isFlat && quadric.kind != gpu::kSphere)
            normal = {point.x / radius,
                      quadric.kind == gpu::kCone ? -quadric.slope * std::copysign(1.0, point.y)
                                                 : 0.0,
                      point.z / radius};
        if (!isFlat && radius < 1e-3 * quadric.radius)
            return;
        const glm::dvec3 world =
            glm::normalize(worldPoint(quadric, normal) - glm::dvec3(quadric.center));
        const double tolerance = 16.0 * kRoundoffOfFloat + (isFlat ? 0.0 : 4.0 * error / radius);
        EXPECT_NEAR(glm::dot(unit(hit.dpdu), world), 0.0, tolerance);
        EXPECT_NEAR(glm::dot(unit(hit.dpdv), world), 0.0, tolerance);
    });
}

// Where u has no direction the answers are numbers all the same.
TEST_P(QuadricCoordinates, AreFiniteOnTheAxis) {
    std::vector<gpu::Quadric> quadrics;
    for (const float extent : {1.5f, -1.5f}) {
        gpu::Quadric quadric{};
        quadric.kind = GetParam();
        quadric.axisX = {1, 0, 0};
        quadric.axisY = {0, 1, 0};
        quadric.axisZ = {0, 0, 1};
        quadric.slope = 0.5f;
        quadric.radius = 0.75f;
        quadric.extent = GetParam() == gpu::kCone ? extent : 1.5f;
        quadrics.push_back(quadric);
    }
    std::vector<gpu::TestRay> rays;
    for (uint32_t i = 0; i < 2; ++i)
        for (const double side : {1.0, -1.0})
            rays.push_back(
                testRay({0.0, 4.0 * side, 0.0}, {0.0, -side, 0.0}, i | gpu::kQuadricBit));
    for (const auto& hit : coordinatesAt(PrimitiveScene::ofQuadrics(quadrics), rays)) {
        EXPECT_LT(hit.t, 10.0f);
        EXPECT_TRUE(hit.u >= 0.0f && hit.u <= 1.0f && hit.v >= 0.0f && hit.v <= 1.0f);
        EXPECT_TRUE(std::isfinite(glm::dot(hit.dpdu, hit.dpdu) + glm::dot(hit.dpdv, hit.dpdv)));
    }
}

INSTANTIATE_TEST_SUITE_P(Of, QuadricCoordinates, testing::ValuesIn(kAllQuadricKinds),
                         [](const auto& instance) { return nameOf(instance.param); });

/// A triangle of some size, not too thin, somewhere near the origin.
gpu::Triangle randomTriangle(double size, RandomNumbers& random) {
    const glm::dmat3 frame = randomRotation(random);
    const glm::dvec3 corner = size * random.inBall();
    gpu::Triangle triangle{};
    triangle.v0 = glm::vec3(corner);
    triangle.v1 = glm::vec3(corner + size * frame[0]);
    triangle.v2 = glm::vec3(corner + size * (random.between(-1.0, 1.0) * frame[0] +
                                             random.between(0.3, 1.0) * frame[2]));
    return triangle;
}

gpu::TestRay rayOnto(const gpu::Triangle& triangle, uint32_t index, RandomNumbers& random) {
    const glm::dvec3 edge1(triangle.v1 - triangle.v0);
    const glm::dvec3 edge2(triangle.v2 - triangle.v0);
    const double b1 = random.between(0.1, 0.8);
    const double b2 = random.between(0.05, 0.95 - b1);
    const glm::dvec3 target = glm::dvec3(triangle.v0) + b1 * edge1 + b2 * edge2;
    const glm::dvec3 outward = glm::normalize(glm::cross(edge1, edge2)) * random.sign();
    const glm::dvec3 direction = -glm::normalize(outward + 0.5 * random.inBall());
    return testRay(target - glm::length(edge1) * direction, direction, index);
}

struct TexturedTriangles {
    std::vector<gpu::Triangle> triangles;
    std::vector<gpu::TriangleUvs> uvs;

    std::vector<gpu::TestCoordinates> coordinates(const std::vector<gpu::TestRay>& rays) const {
        GpuScene scene;
        scene.triangles = triangles;
        scene.triangleUvs = uvs;
        return coordinatesAt(PrimitiveScene(std::move(scene)), rays);
    }
};

/// The affine map from a triangle's plane to its texture coordinates.
class UvMap {
public:
    UvMap(const gpu::Triangle& triangle, const gpu::TriangleUvs& uvs)
        : corner_(triangle.v0), edge1_(glm::dvec3(triangle.v1) - corner_),
          edge2_(glm::dvec3(triangle.v2) - corner_), uv_(uvs.uv0),
          along1_(glm::dvec2(uvs.uv1) - uv_), along2_(glm::dvec2(uvs.uv2) - uv_) {}

    glm::dvec2 slope(const glm::dvec3& direction) const {
        const glm::dvec3 normal = glm::cross(edge1_, edge2_);
        const double area2 = glm::dot(normal, normal);
        const double b1 = glm::dot(glm::cross(direction, edge2_), normal) / area2;
        const double b2 = glm::dot(glm::cross(edge1_, direction), normal) / area2;
        return b1 * along1_ + b2 * along2_;
    }

    glm::dvec2 at(const glm::dvec3& world) const { return uv_ + slope(world - corner_); }

    double determinant() const { return along1_.x * along2_.y - along2_.x * along1_.y; }
    double extent() const { return glm::length(along1_) + glm::length(along2_); }

    /// By how much the directions' rounding is magnified where the coordinates are stretched or
    /// sheared: 1 where they are square.
    double shear() const { return extent() * extent() / std::abs(determinant()); }

private:
    glm::dvec3 corner_;
    glm::dvec3 edge1_;
    glm::dvec3 edge2_;
    glm::dvec2 uv_;
    glm::dvec2 along1_;
    glm::dvec2 along2_;
};

class TriangleCoordinates : public GpuTest {};

TEST_F(TriangleCoordinates, AreInterpolatedAndGrowAlongTheirDirectionsMirroredOrNot) {
    RandomNumbers random(112);
    TexturedTriangles scene;
    std::vector<gpu::TestRay> rays;
    for (uint32_t i = 0; i < 6000; ++i) {
        scene.triangles.push_back(randomTriangle(random.powerOfTen(-3.0, 3.0), random));
        const double scale = random.powerOfTen(-4.0, 2.0);
        const auto uv = [&] {
            return glm::vec2(scale * random.between(-1.0, 1.0), scale * random.between(-1.0, 1.0));
        };
        scene.uvs.push_back({uv(), uv(), uv(), 0, 0});
        rays.push_back(rayOnto(scene.triangles[i], i, random));
    }
    const auto results = scene.coordinates(rays);
    int checked[2] = {0, 0};
    for (size_t i = 0; i < rays.size(); ++i) {
        const UvMap map(scene.triangles[i], scene.uvs[i]);
        const glm::dvec2 wanted = map.at(glm::dvec3(results[i].position));
        const double largest = map.extent() + glm::length(glm::dvec2(scene.uvs[i].uv0));
        ASSERT_NEAR(results[i].u, wanted.x, 64.0 * kRoundoffOfFloat * largest);
        ASSERT_NEAR(results[i].v, wanted.y, 64.0 * kRoundoffOfFloat * largest);
        if (map.shear() > 1e3)
            continue;
        ++checked[map.determinant() < 0.0];
        expectGrowth(
            results[i], [&](const glm::dvec3& d) { return map.slope(d); },
            16.0 * kRoundoffOfFloat * map.shear() * map.shear());
        if (HasFailure())
            return;
    }
    EXPECT_GT(std::min(checked[0], checked[1]), 2000);
}

TEST_F(TriangleCoordinates, AreFiniteWhereTheyDegenerate) {
    RandomNumbers random(113);
    TexturedTriangles scene;
    std::vector<gpu::TestRay> rays;
    const gpu::TriangleUvs degenerate[] = {
        {{0, 0}, {0, 0}, {0, 0}, 0, 0},                   // none given
        {{0.3f, 0.7f}, {0.3f, 0.7f}, {0.3f, 0.7f}, 0, 0}, // one texel
        {{0, 0}, {1, 0}, {0.5f, 0}, 0, 0},                // a line along u
        {{0.1f, 0.1f}, {0.4f, 0.7f}, {0.2f, 0.3f}, 0, 0}, // a slanted line, but for rounding
        {{0, 0}, {1e-30f, 0}, {0, 1e-30f}, 0, 0},         // whose determinant underflows
        {{0, 0}, {1e15f, 0}, {0, 1e15f}, 0, 0},
    };
    for (uint32_t i = 0; i < 600; ++i) {
        scene.triangles.push_back(randomTriangle(random.powerOfTen(-3.0, 3.0), random));
        scene.uvs.push_back(degenerate[i % std::size(degenerate)]);
        rays.push_back(rayOnto(scene.triangles[i], i, random));
    }
    for (const gpu::TestCoordinates& hit : scene.coordinates(rays)) {
        EXPECT_TRUE(std::isfinite(hit.u) && std::isfinite(hit.v));
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_TRUE(std::isfinite(hit.dpdu[axis]) && std::isfinite(hit.dpdv[axis]));
    }
}

} // namespace
} // namespace calotype::test
