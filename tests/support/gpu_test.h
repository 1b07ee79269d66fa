#pragma once

#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"
#include "gpu/device.h"
#include "gpu/instance.h"
#include "shared/bindings.h"

namespace calotype::test {

/// The device that all tests of this process share: chosen as the program would choose it, with the
/// validation layers unless CALOTYPE_VALIDATION is 0. No device is a failure, not a skip.
const Device& testDevice();

/// Base of tests that use the device: fails where the validation layers said anything.
class GpuTest : public testing::Test {
protected:
    void TearDown() override;
};

/// First binding of the input and output arrays in kernels that include buffers/packed_scene.glsl.
inline constexpr uint32_t kTestInputBinding = shared::kBindingCount;

/// A test kernel that maps an array of inputs to an array of outputs.
///
/// Binding 0 is a read-only storage buffer of In, binding 1 a storage buffer of Out, both std430;
/// binding numbers of the scene are shifted away, so kernels that read a scene as well list its
/// bindings in `scene` and put their own arrays at `inputBinding` and the one after it. One
/// invocation works on one element: the kernel's local size is 64, and it must check the length.
template <typename Out, typename In>
std::vector<Out> runKernel(std::span<const uint32_t> spirv, const std::vector<In>& inputs,
                           const std::vector<Binding>& scene = {}, uint32_t inputBinding = 0,
                           const std::vector<vk::Bool32>& constants = {}) {
    constexpr uint32_t kLocalSize = 64;
    const Device& device = testDevice();
    const Buffer in(device, inputs.size() * sizeof(In), vk::BufferUsageFlagBits::eStorageBuffer,
                    Buffer::Memory::Host, "test input");
    const Buffer out(device, inputs.size() * sizeof(Out), vk::BufferUsageFlagBits::eStorageBuffer,
                     Buffer::Memory::Host, "test output");
    std::copy(inputs.begin(), inputs.end(), in.mapped<In>().begin());
    std::vector<Binding> bindings = scene;
    bindings.push_back(Binding::storageBuffer(inputBinding, in));
    bindings.push_back(Binding::storageBuffer(inputBinding + 1, out));
    const ComputePipeline pipeline(
        device, {.name = "test", .spirv = spirv, .bindings = bindings, .constants = constants});
    const auto groups = static_cast<uint32_t>((inputs.size() + kLocalSize - 1) / kLocalSize);
    pipeline.run(device, groups);
    const std::span<Out> results = out.mapped<Out>();
    return {results.begin(), results.end()};
}

} // namespace calotype::test
