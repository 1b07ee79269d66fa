// The shadow terminator: a coarse ball with smooth normals is lit as the ball that it stands for.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "image/coarse_ball.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

/// The ball lit by a small far lamp on the right, whose terminator runs along no edges of the mesh;
/// seen by parallel rays.
Image litBall(Shape ball) {
    SceneBuilder builder;
    builder.material(0.8, 0.0);
    const uint32_t lamp = builder.material(0.0, 1e5, true);
    const glm::dvec3 toLamp = glm::normalize(glm::dvec3(0.8, 0.4, 0.3));
    const glm::dvec3 across = glm::normalize(glm::cross(toLamp, glm::dvec3(0.0, 1.0, 0.0)));
    const glm::dvec3 up = glm::cross(across, toLamp);
    builder.rectangle(50.0 * toLamp - 0.5 * (across + up), across, up, lamp); // faces the ball
    builder.add(std::move(ball));
    builder.lookAtPlaneZ(2.1);
    Scene& scene = builder.scene();
    scene.film = {96, 96};
    scene.render = {16, 1, 0};
    return renderScene(scene).image;
}

class TerminatorTest : public GpuTest {};

// Pixels that are black on the mesh where the ball has a twentieth of its brightest light or more:
// whole steps of triangles without the curved patch, next to none with it.
TEST_F(TerminatorTest, CoarseMeshIsLitLikeTheBallItStandsFor) {
    const Image ball = litBall(makeShape(Sphere{{}, 1.0}, 0));
    float brightest = 0.0f;
    for (const glm::vec3& pixel : ball.pixels)
        brightest = std::max(brightest, pixel.x);
    for (const int levels : {2, 3}) {
        const Image mesh = litBall(makeShape(coarseBall(levels), 0));
        size_t lit = 0;
        size_t dark = 0;
        for (uint32_t y = 0; y < ball.height; ++y)
            for (uint32_t x = 0; x < ball.width; ++x) {
                const double u = (x + 0.5) / ball.width * 2.1 - 1.05;
                const double v = (y + 0.5) / ball.height * 2.1 - 1.05;
                const bool nearOutline = u * u + v * v > 0.75; // there the meshes' shapes differ
                if (nearOutline || ball.at(x, y).x < 0.05f * brightest)
                    continue;
                ++lit;
                dark += mesh.at(x, y).x < 0.5f * ball.at(x, y).x ? 1 : 0;
            }
        EXPECT_GT(lit, 1000u);
        EXPECT_LT(dark, lit / 500) << levels << " levels";
    }
}

} // namespace
} // namespace calotype::test
