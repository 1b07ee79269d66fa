// Samples that come out as no number: none is hidden as black.
#include <limits>

#include "reference/reference_tracer.h"
#include "render/reference_block.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

using LostSampleTest = GpuTest;

shared::RenderCounters oneSampleOfEach(BlockTracer& tracer) {
    tracer.beginBlock(0);
    return tracer.renderTiles({0, tracer.tileCount()}, 1);
}

// In the dark, so that the picture is black with or without them. No reader lets such a colour in.
TEST_F(LostSampleTest, PathsOfNoFiniteWeightAreCounted) {
    constexpr uint32_t kSide = 8;
    SceneBuilder builder;
    builder.add(makeShape(Sphere{}, builder.material(std::numeric_limits<double>::quiet_NaN(), 0)));
    builder.lookAtPlaneZ(0.1);
    builder.scene().render.maxBounces = 1;
    const RenderSettings settings = squareSettings(builder.scene(), kSide, 0);
    DeviceTracer device(builder.scene(), settings);
    EXPECT_EQ(oneSampleOfEach(device.tracer()).nonFiniteSamples, kSide * kSide);
    const reference::ReferenceTracer reference(builder.scene(), {kSide, kSide},
                                               settings.maxBounces);
    ReferenceBlock block(reference, settings, 2);
    EXPECT_EQ(oneSampleOfEach(block).nonFiniteSamples, kSide * kSide);
}

} // namespace
} // namespace calotype::test
