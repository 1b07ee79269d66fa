// Texture coordinates on triangles, and the directions in which they grow, against the affine map
// in double.
#include <cmath>

#include "gpu/coordinates_at.h"
#include "pack/pack_shapes.h"
#include "support/test_quadrics.h"

namespace calotype::test {
namespace {

/// A triangle of some size, not too thin, somewhere near the origin.
shared::Triangle randomTriangle(double size, RandomNumbers& random) {
    const glm::dmat3 frame = randomRotation(random);
    const glm::dvec3 corner = size * random.inBall();
    const glm::vec3 v0(corner);
    const glm::vec3 v1(corner + size * frame[0]);
    const glm::vec3 v2(corner + size * (random.between(-1.0, 1.0) * frame[0] +
                                        random.between(0.3, 1.0) * frame[2]));
    return packTriangle(v0, v1, v2);
}

shared::TestRay rayOnto(const shared::Triangle& triangle, uint32_t index, RandomNumbers& random) {
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
    std::vector<shared::Triangle> triangles;
    std::vector<shared::TriangleUvs> uvs;

    std::vector<shared::TestCoordinates>
    coordinates(const std::vector<shared::TestRay>& rays) const {
        GpuScene scene;
        scene.triangles = triangles;
        scene.triangleUvs = uvs;
        return coordinatesAt(PrimitiveScene(std::move(scene)), rays);
    }
};

/// The affine map from a triangle's plane to its texture coordinates.
class UvMap {
public:
    UvMap(const shared::Triangle& triangle, const shared::TriangleUvs& uvs)
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

class TriangleCoordinatesTest : public GpuTest {};

TEST_F(TriangleCoordinatesTest, AreInterpolatedAndGrowAlongTheirDirectionsMirroredOrNot) {
    RandomNumbers random(112);
    TexturedTriangles scene;
    std::vector<shared::TestRay> rays;
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

TEST_F(TriangleCoordinatesTest, AreFiniteWhereTheyDegenerate) {
    RandomNumbers random(113);
    TexturedTriangles scene;
    std::vector<shared::TestRay> rays;
    const shared::TriangleUvs degenerate[] = {
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
    for (const shared::TestCoordinates& hit : scene.coordinates(rays)) {
        EXPECT_TRUE(std::isfinite(hit.u) && std::isfinite(hit.v));
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_TRUE(std::isfinite(hit.dpdu[axis]) && std::isfinite(hit.dpdv[axis]));
    }
}

} // namespace
} // namespace calotype::test
