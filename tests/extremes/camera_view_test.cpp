// Views of extreme width, and lenses of extreme size and focus.
#include <algorithm>
#include <cmath>
#include <iostream>

#include <glm/geometric.hpp>

#include "extremes/judgement.h"
#include "reference/reference_tracer.h"
#include "support/first_hits.h"
#include "support/gpu_test.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

class CameraViewTest : public GpuTest {};
class SlowCameraViewTest : public GpuTest {};

constexpr uint32_t kSide = 256; ///< pixels
constexpr double kDegree = std::numbers::pi / 180.0;
/// Half the side of the wall, in half heights of the view in its plane.
constexpr double kWall = 1.1;

Camera cameraAlong(const glm::dvec3& direction, const glm::dvec3& position) {
    Camera camera;
    camera.position = position;
    camera.forward = glm::normalize(direction);
    camera.right = glm::normalize(glm::cross(camera.forward, {0.0, 1.0, 0.0}));
    camera.up = glm::cross(camera.right, camera.forward);
    return camera;
}

Camera axial() { return cameraAlong({0.0, 0.0, -1.0}, {0.0, 0.0, 0.0}); }
Camera oblique() { return cameraAlong({0.5, -0.4, -0.7}, {3.1, 2.2, 1.3}); }

/// A wall that fills the view at some distance; something behind the camera keeps it within the
/// scene's bounds.
Scene wallAt(const Camera& camera, double distance) {
    const bool isOrthographic = camera.projection == Projection::Orthographic;
    const double half = kWall * (isOrthographic ? 0.5 * camera.viewHeight
                                                : distance * std::tan(0.5 * camera.verticalFov));
    const glm::dvec3 center = camera.position + distance * camera.forward;
    SceneBuilder builder;
    const uint32_t checkers = builder.texture(
        {"checkers", CheckerTexture{{glm::dvec3(0.2), glm::dvec3(0.9)}}, {7.0, 7.0}});
    Material wall;
    wall.color = glm::dvec3(1.0);
    wall.colorTexture = checkers;
    builder.rectangle(center - half * (camera.right + camera.up), 2.0 * half * camera.right,
                      2.0 * half * camera.up, builder.material(wall));
    builder.add(
        makeShape(Sphere{{glm::dmat3(1.0), camera.position - 5.0 * camera.forward}, 1.0}, 0));
    builder.scene().camera = camera;
    builder.scene().film = {kSide, kSide};
    builder.scene().background = glm::dvec3(1.0);
    builder.scene().render.maxBounces = 1;
    return builder.scene();
}

/// How far the device's rays land from where they should, in pixels, by texture coordinates.
struct Deviation {
    double rootMeanSquare = 0.0;
    double worst = 0.0;
};

Deviation deviationOf(const Scene& scene) {
    const FirstHits hits = firstHitsOf(scene);
    const reference::ReferenceTracer reference(scene, {kSide, kSide}, 1);
    constexpr double kPixel = 1.0 / (kWall * kSide);
    Deviation deviation;
    size_t count = 0;
    for (uint32_t y = 0; y < kSide; y += 3)
        for (uint32_t x = 0; x < kSide; x += 3) {
            const FirstHit expected = reference.firstHit({x, y});
            const FirstHit& seen = hits.image.at(x, y);
            EXPECT_EQ(seen.primitive == kNoPrimitive, expected.primitive == kNoPrimitive);
            const double pixels =
                glm::distance(glm::dvec2(seen.uv), glm::dvec2(expected.uv)) / kPixel;
            deviation.rootMeanSquare += pixels * pixels;
            deviation.worst = std::max(deviation.worst, pixels);
            ++count;
        }
    deviation.rootMeanSquare = std::sqrt(deviation.rootMeanSquare / static_cast<double>(count));
    std::cout << "  deviation " << deviation.rootMeanSquare << " pixels, at worst "
              << deviation.worst << "\n";
    return deviation;
}

/// A field of view in degrees, or the height of an orthographic view in metres, and the distance of
/// the wall in metres.
struct View {
    double size, distance;
};

Scene scenePerspective(Camera camera, View view) {
    camera.verticalFov = view.size * kDegree;
    return wallAt(camera, view.distance);
}

Scene sceneOrthographic(Camera camera, View view) {
    camera.projection = Projection::Orthographic;
    camera.viewHeight = view.size;
    return wallAt(camera, view.distance);
}

// Texture coordinates are exact to 2^-24 of the wall, which is 256 pixels wide: to 1e-5 pixels.
void expectSharp(const Scene& scene) {
    EXPECT_LT(deviationOf(scene).worst, 1e-3);
    expectJudgement(judge(scene, 16, 4), 1e-4);
}

/// A unit vector of single precision is rounded by up to 2.2e-7 rad (measured): a share of a pixel
/// that grows as the view shrinks.
constexpr double kRayError = 2.5e-7;

// At 179.9 degrees pixels at the centre are wide and those at the edge are seen at 0.05 degrees to
// the wall.
void expectAsSharpAsRaysAre(View view) {
    const Scene scene = scenePerspective(oblique(), view);
    const double halfView = std::tan(0.5 * view.size * kDegree);
    const double pixelAngle = 2.0 * halfView / kSide / (1.0 + 2.0 * halfView * halfView);
    EXPECT_LT(deviationOf(scene).worst, kRayError / pixelAngle + 1e-3);
    expectJudgement(judge(scene, 16, 4), 1e-3);
}

TEST_F(CameraViewTest, AlongAnAxisEveryFieldOfViewIsSharp) {
    for (const View view : {View{1e-3, 1e6}, {179.9, 1.0}})
        expectSharp(scenePerspective(axial(), view));
}

TEST_F(CameraViewTest, AskewThePixelsAngleLimitsTheView) {
    for (const View view : {View{1e-3, 1e6}, {179.9, 1.0}})
        expectAsSharpAsRaysAre(view);
}

TEST_F(CameraViewTest, ParallelRaysAlongAnAxis) {
    for (const View view : {View{1e-6, 10.0}, {1e6, 10.0}})
        expectSharp(sceneOrthographic(axial(), view));
}

// Askew a small view is as sharp where it looks at what is near.
TEST_F(CameraViewTest, ParallelRaysAskewAreSharpNearby) {
    for (const View view : {View{1e-6, 2e-6}, {1e-6, 1e-3}, {1e-3, 10.0}, {1.0, 10.0}, {1e6, 1e3}})
        EXPECT_LT(deviationOf(sceneOrthographic(oblique(), view)).worst,
                  kRayError * view.distance / (view.size / kSide) + 1e-3);
}

TEST_F(SlowCameraViewTest, OfAnySizeAndDistance) {
    for (const double distance : {1.0, 1e6}) {
        for (const double fov : {1e-3, 1e-2, 1.0, 40.0, 179.9}) {
            SCOPED_TRACE(testing::Message() << fov << " degrees at " << distance << " m");
            expectSharp(scenePerspective(axial(), {fov, distance}));
            expectAsSharpAsRaysAre({fov, distance});
        }
        for (const double height : {1e-6, 1.0, 1e6}) {
            SCOPED_TRACE(testing::Message() << height << " m high at " << distance << " m");
            expectSharp(sceneOrthographic(axial(), {height, distance}));
        }
    }
}

struct Lens {
    double radius, focus, distance;
    bool isAskew;
};

// A lens much wider than its focus is far sends its rays across the view; askew they are sharp up
// to a hundredfold.
void expectEnergyThrough(const Lens& lens) {
    SCOPED_TRACE(testing::Message()
                 << "lens of " << lens.radius << " m, focus at " << lens.focus << " m, wall at "
                 << lens.distance << " m" << (lens.isAskew ? ", askew" : ""));
    Camera camera = lens.isAskew ? oblique() : axial();
    camera.lensRadius = lens.radius;
    camera.focusDistance = lens.focus;
    expectJudgement(judge(scenePerspective(camera, {40.0, lens.distance}), 16, 4), 1e-3);
}

TEST_F(CameraViewTest, LensesOfAnySizeAndFocus) {
    for (const Lens& lens :
         {Lens{0.0, 1e-3, 1e-3, false}, {0.1, 1e-3, 1e-3, true}, {10.0, 1e6, 1e6, true}})
        expectEnergyThrough(lens);
}

TEST_F(SlowCameraViewTest, LensesOfAnySizeAndFocus) {
    for (const Lens& lens : {Lens{0.0, 1e6, 1e6, true},
                             {1e-6, 1.0, 1.0, true},
                             {10.0, 1.0, 1.0, false},
                             {10.0, 1.0, 1.0, true},
                             {10.0, 1e6, 3.0, true},
                             {10.0, 1e-3, 1e-3, false}})
        expectEnergyThrough(lens);
}

} // namespace
} // namespace calotype::test
