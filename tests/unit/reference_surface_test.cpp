#include <gtest/gtest.h>

#include "unit/reference_shapes.h"

// Texture coordinates and shading normals, as scene-format.md says.

namespace calotype::test {
namespace {

using reference::Geometry;
using reference::Ray;
using reference::Surface;

/// The surface that a ray through `target` along `direction` meets first, from `distance` before.
Surface surfaceAt(const Geometry& geometry, const glm::dvec3& target, const glm::dvec3& direction,
                  double distance = 0.1) {
    const glm::dvec3 d = glm::normalize(direction);
    const Ray ray{target - distance * d, d};
    const auto hit = geometry.closest(ray);
    EXPECT_TRUE(hit);
    return hit ? geometry.surface(*hit, ray) : Surface{};
}

struct KnownUv {
    glm::dvec3 target;
    glm::dvec3 direction;
    glm::dvec2 uv;
};

void expectUvs(const Shape& shape, const std::vector<KnownUv>& known) {
    const Scene scene = sceneOf({shape});
    const Geometry geometry(scene);
    for (const auto& [target, direction, uv] : known) {
        const Surface surface = surfaceAt(geometry, target, direction);
        EXPECT_NEAR(surface.uv.x, uv.x, 1e-15) << target.x << " " << target.y << " " << target.z;
        EXPECT_NEAR(surface.uv.y, uv.y, 1e-15) << target.x << " " << target.y << " " << target.z;
    }
}

TEST(ReferenceUvTest, OfASphere) {
    expectUvs(shapeOf(Sphere{{}, 2.0}),
              {{{2, 0, 0}, {-1, 0, 0}, {0.0, 0.5}},
               {{0, 0, 2}, {0, 0, -1}, {0.25, 0.5}},
               {{-2, 0, 0}, {1, 0, 0}, {0.5, 0.5}},
               {{0, 0, -2}, {0, 0, 1}, {0.75, 0.5}},
               {{0, 2, 0}, {0, -1, 0}, {0.0, 1.0}},
               {{0, -2, 0}, {0, 1, 0}, {0.0, 0.0}},
               {{0, std::sqrt(2.0), std::sqrt(2.0)}, {0, -1, -1}, {0.25, 0.75}}});
}

TEST(ReferenceUvTest, OfACylinder) {
    expectUvs(shapeOf(Cylinder{{}, 2.0, 4.0}), {{{2, 0, 0}, {-1, 0, 0}, {0.0, 0.5}},
                                                {{0, 1, 2}, {0, 0, -1}, {0.25, 0.75}},
                                                {{0, -1, -2}, {0, 0, 1}, {0.75, 0.25}},
                                                {{1, 2, -1}, {0, -1, 0}, {0.75, 0.25}},
                                                {{1, -2, -1}, {0, 1, 0}, {0.75, 0.25}}});
}

TEST(ReferenceUvTest, OfACone) {
    expectUvs(shapeOf(Cone{{}, 4.0, 0.5}), {{{0, 1, 0.5}, {0, 0, -1}, {0.25, 0.25}},
                                            {{-1.5, 3, 0}, {1, 0, 0}, {0.5, 0.75}},
                                            {{1, 4, -1}, {0, -1, 0}, {0.75, 0.25}}});
    expectUvs(shapeOf(Cone{{}, -4.0, 0.5}), {{{0, -1, 0.5}, {0, 0, -1}, {0.25, 0.75}},
                                             {{-1.5, -3, 0}, {1, 0, 0}, {0.5, 0.25}},
                                             {{1, -4, -1}, {0, 1, 0}, {0.75, 0.25}}});
}

TEST(ReferenceUvTest, OfADisk) {
    expectUvs(shapeOf(Disk{{}, 2.0}),
              {{{1, 0, -1}, {0, -1, 0}, {0.75, 0.25}}, {{-2, 0, 0}, {0, 1, 0}, {0.0, 0.5}}});
}

TEST(ReferenceUvTest, IsDefinedAtPolesAndApex) {
    const Scene scene = sceneOf({shapeOf(Sphere{}), shapeOf(Cone{{glm::dmat3(1.0), {5, 0, 0}}})});
    const Geometry geometry(scene);
    const Surface pole = surfaceAt(geometry, {0, 1, 0}, {0, -1, 0});
    EXPECT_EQ(pole.dpdu, glm::dvec3(0.0));
    EXPECT_EQ(pole.dpdv, glm::dvec3(0.0));
    const Surface apex = surfaceAt(geometry, {5, 0, 0}, {0, 1, 0});
    EXPECT_EQ(apex.uv, glm::dvec2(0.0));
    EXPECT_EQ(apex.ng, glm::dvec3(0, -1, 0));
    EXPECT_EQ(apex.dpdu, glm::dvec3(0.0));
    EXPECT_EQ(apex.dpdv, glm::dvec3(0.0));
}

// A step along the surface is, but for its curvature, what the derivatives say of the step in u, v.
void expectDerivatives(const Shape& shape, const SurfacePoint& point, RandomNumbers& random) {
    const Scene scene = sceneOf({shape});
    const Geometry geometry(scene);
    constexpr double kStep = 1e-5;
    const glm::dvec3 tangent = glm::normalize(glm::cross(point.normal, random.direction()));
    // Faces are at least 0.01 wide, and points a thousandth of half of this from their rims.
    const glm::dvec3 step = kStep * std::min(point.radius, 0.4) * tangent;
    const Surface before = surfaceAt(geometry, point.position - step, -point.normal);
    const Surface here = surfaceAt(geometry, point.position, -point.normal);
    const Surface after = surfaceAt(geometry, point.position + step, -point.normal);
    const glm::dvec2 uvStep = after.uv - before.uv;
    if (std::abs(uvStep.x) > 0.5 || glm::dot(before.ng, after.ng) < 0.9)
        return; // across the seam of u, or a rim
    const glm::dvec3 predicted = uvStep.x * here.dpdu + uvStep.y * here.dpdv;
    // The central difference is off by the step's square over the radius's, about 1e-10, and by
    // roundings of some 1e-16 in positions and coordinates, over steps of at least 1e-10.
    ASSERT_LT(glm::distance(predicted, after.position - before.position), 1e-5 * glm::length(step))
        << nameOf(QuadricKind(shape.geometry.index()));
}

TEST(ReferenceDerivativesTest, AgreeWithStepsOnQuadrics) {
    RandomNumbers random(41);
    for (const QuadricKind kind : kQuadricKinds) {
        for (int i = 0; i < 2000; ++i) {
            const Shape shape = randomQuadric(kind, random.inBall(), 1.0, random);
            expectDerivatives(shape, pointOf(shape, random), random);
            if (HasFatalFailure())
                return;
        }
    }
}

Mesh texturedTriangle(RandomNumbers& random) {
    Mesh mesh =
        singleTriangle(random.direction(), 2.0 * random.direction(), 3.0 * random.direction());
    for (uint32_t k = 0; k < 3; ++k) {
        mesh.uvs.push_back({random.between(-2.0, 2.0), random.between(-2.0, 2.0)});
        mesh.triangles[0].uv[k] = k;
    }
    return mesh;
}

TEST(ReferenceDerivativesTest, AndCoordinatesOfATriangleAreLinear) {
    RandomNumbers random(42);
    for (int i = 0; i < 2000; ++i) {
        const Mesh mesh = texturedTriangle(random);
        const glm::dvec3* p = mesh.positions.data();
        const glm::dvec2* uv = mesh.uvs.data();
        const glm::dvec3 areaVector = glm::cross(p[1] - p[0], p[2] - p[0]);
        const glm::dvec2 a = uv[1] - uv[0];
        const glm::dvec2 b = uv[2] - uv[0];
        if (glm::length(areaVector) < 0.1 || std::abs(a.x * b.y - a.y * b.x) < 0.1)
            continue;
        const Scene scene = sceneOf({shapeOf(mesh)});
        const glm::dvec3 w(0.2, 0.5, 0.3);
        const Surface surface = surfaceAt(Geometry(scene), w.x * p[0] + w.y * p[1] + w.z * p[2],
                                          -glm::normalize(areaVector));
        ASSERT_LT(glm::distance(surface.uv, w.x * uv[0] + w.y * uv[1] + w.z * uv[2]), 1e-12);
        ASSERT_LT(glm::distance(a.x * surface.dpdu + a.y * surface.dpdv, p[1] - p[0]), 1e-12);
        ASSERT_LT(glm::distance(b.x * surface.dpdu + b.y * surface.dpdv, p[2] - p[0]), 1e-12);
    }
}

TEST(ReferenceDerivativesTest, AreZeroWithoutCoordinates) {
    RandomNumbers random(43);
    Mesh mesh = texturedTriangle(random);
    mesh.uvs = {glm::dvec2(0.3), glm::dvec2(0.3), glm::dvec2(0.3)};
    for (const uint32_t uv : {0u, Mesh::kNoUv}) {
        std::ranges::fill(mesh.triangles[0].uv, uv);
        const Scene scene = sceneOf({shapeOf(mesh)});
        const glm::dvec3* p = mesh.positions.data();
        const Surface surface = surfaceAt(Geometry(scene), (p[0] + p[1] + p[2]) / 3.0,
                                          glm::cross(p[1] - p[0], p[2] - p[0]));
        // The three weights sum to 1 within rounding.
        const double wanted = uv == 0 ? 0.3 : 0.0;
        EXPECT_NEAR(surface.uv.x, wanted, 8.0 * 0x1p-53 * wanted);
        EXPECT_NEAR(surface.uv.y, wanted, 8.0 * 0x1p-53 * wanted);
        EXPECT_EQ(surface.dpdu, glm::dvec3(0.0));
        EXPECT_EQ(surface.dpdv, glm::dvec3(0.0));
    }
}

/// A roof of one triangle in the plane y = 0, its front up; its normals lean outward by the slope
/// (convex), or inward (a negative slope).
Mesh leaningTriangle(double slope, double turn) {
    Mesh mesh = singleTriangle({-1, 0, 0}, {1, 0, 0}, {0, 0, -2});
    for (uint32_t k = 0; k < 3; ++k) {
        const glm::dvec3 outward =
            mesh.positions[k] - glm::dvec3(0.0, 0.0, -2.0 / 3.0); // from the middle
        mesh.normals.push_back(turn * glm::normalize(glm::dvec3(0, 1, 0) + slope * outward));
        mesh.triangles[0].normal[k] = k;
    }
    return mesh;
}

TEST(ReferenceSmoothNormalsTest, LieBetweenThoseOfTheCornersOnTheSideOfTheFront) {
    for (const double turn : {1.0, -1.0}) { // a file's normals may point to the back
        const Mesh mesh = leaningTriangle(0.5, turn);
        const Scene scene = sceneOf({shapeOf(mesh)});
        const Geometry geometry(scene);
        const Surface surface = surfaceAt(geometry, {0.5, 0, 0}, {0, -1, 0});
        EXPECT_EQ(surface.ng, glm::dvec3(0, 1, 0));
        const glm::dvec3 expected =
            glm::normalize(turn * (0.25 * mesh.normals[0] + 0.75 * mesh.normals[1]));
        EXPECT_LT(glm::distance(surface.ns, expected), 1e-15);
        EXPECT_GT(surface.ns.x, 0.1);
    }
}

TEST(ReferenceSmoothNormalsTest, CurveTheSurfaceTowardsTheSideWhereItIsConvex) {
    for (const double turn : {1.0, -1.0}) {
        for (const double slope : {0.5, -0.5}) {
            const Scene scene = sceneOf({shapeOf(leaningTriangle(slope, turn))});
            const Geometry geometry(scene);
            for (const double viewer : {1.0, -1.0}) {
                const Surface surface = surfaceAt(geometry, {0.0, 0, 0}, {0, -viewer, 0});
                const bool isConvex = slope * viewer > 0.0;
                EXPECT_EQ(surface.horizon, isConvex ? surface.ns : surface.ng);
                if (!isConvex) {
                    EXPECT_EQ(surface.toSmooth, glm::dvec3(0.0));
                    continue;
                }
                // In the middle of an edge, of length 2: both corners' tangent planes are one unit
                // away, tilted by n = (+-s, 1, s') / length. A point at the distance 1 along x lies
                // s / length below each; the mean of both ways back up has no x.
                const glm::dvec3 n = glm::normalize(glm::dvec3(0, 1, 0) +
                                                    std::abs(slope) * glm::dvec3(1, 0, 2.0 / 3.0));
                const glm::dvec3 up = n.x * glm::dvec3(0.0, n.y, n.z);
                const glm::dvec3 expected = viewer > 0.0 ? up : glm::dvec3(up.x, -up.y, up.z);
                EXPECT_LT(glm::distance(surface.toSmooth, expected), 1e-15);
            }
        }
    }
}

TEST(ReferenceSmoothNormalsTest, OfASaddleCurveItByTheConvexCornersOnly) {
    Mesh mesh = leaningTriangle(0.5, 1.0);
    // The middle of the edge lies below the plane of the corner at x = 1, and above the other's.
    mesh.normals[0] = glm::normalize(glm::dvec3(1, 4, 0));
    mesh.normals[1] = glm::normalize(glm::dvec3(1, 4, 0));
    const Scene scene = sceneOf({shapeOf(mesh)});
    const Surface surface = surfaceAt(Geometry(scene), {0, 0, 0}, {0, -1, 0});
    EXPECT_LT(glm::distance(surface.toSmooth, 0.5 * glm::dvec3(1, 4, 0) / 17.0), 1e-15);
    EXPECT_EQ(surface.horizon, surface.ns);
}

TEST(ReferenceSmoothNormalsTest, LeaveFlatTrianglesFlat) {
    Mesh mesh = leaningTriangle(0.0, 1.0);
    for (const bool hasNormals : {true, false}) {
        if (!hasNormals)
            std::ranges::fill(mesh.triangles[0].normal, Mesh::kNoNormal);
        const Scene scene = sceneOf({shapeOf(mesh)});
        const Surface surface = surfaceAt(Geometry(scene), {0.1, 0, -0.5}, {0.3, -1, 0});
        EXPECT_EQ(surface.ns, glm::dvec3(0, 1, 0));
        EXPECT_EQ(surface.horizon, glm::dvec3(0, 1, 0));
        EXPECT_EQ(surface.toSmooth, glm::dvec3(0.0));
    }
}

TEST(ReferenceSmoothNormalsTest, ThatCancelAreTheTrianglesOwn) {
    Mesh mesh = leaningTriangle(0.0, 1.0);
    mesh.normals = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
    const Scene scene = sceneOf({shapeOf(mesh)});
    const Surface surface = surfaceAt(Geometry(scene), {0, 0, 0}, {0, -1, 0});
    EXPECT_EQ(surface.ns, glm::dvec3(0, 1, 0));
}

} // namespace
} // namespace calotype::test
