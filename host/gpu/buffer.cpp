#include "gpu/buffer.h"

#include <algorithm>
#include <cstring>

#include "base/huge_pages.h"

namespace calotype {
namespace {

constexpr size_t kBytesPerRow = 16;

std::span<const std::byte> checkRows(const Device& device, std::span<const std::byte> contents,
                                     const std::string& name) {
    const uint64_t rows = contents.size() / kBytesPerRow;
    const uint64_t limit = device.limits().maxTexelBufferElements;
    if (rows > limit)
        throw GpuError("the scene's " + name + " take " + std::to_string(contents.size() >> 20) +
                       " MiB, and '" + device.info().name + "' can address " +
                       std::to_string((limit * kBytesPerRow) >> 20) + " MiB in one buffer");
    return contents;
}

/// Makes copied data visible to the kernels of later submissions, and to the host.
void showWritten(const vk::raii::CommandBuffer& commands) {
    using Access = vk::AccessFlagBits;
    const vk::MemoryBarrier barrier(Access::eTransferWrite,
                                    Access::eShaderRead | Access::eShaderWrite |
                                        Access::eUniformRead | Access::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eTransfer,
                             vk::PipelineStageFlagBits::eComputeShader |
                                 vk::PipelineStageFlagBits::eHost,
                             {}, barrier, {}, {});
}

} // namespace

Buffer::Buffer(const Device& device, size_t bytes, vk::BufferUsageFlags usage, Memory memory,
               const std::string& name)
    : bytes_(bytes) {
    callVulkan([&] {
        buffer_ = device.handle().createBuffer({{}, bytes, usage});
        device.setName(buffer_, name);
        const auto requirements = buffer_.getMemoryRequirements();
        using Flag = vk::MemoryPropertyFlagBits;
        const vk::MemoryPropertyFlags mappable = Flag::eHostVisible | Flag::eHostCoherent;
        const uint32_t type = device.memoryType(
            requirements.memoryTypeBits, memory == Memory::Host ? mappable : Flag::eDeviceLocal);
        memory_ = device.handle().allocateMemory({requirements.size, type});
        buffer_.bindMemory(*memory_, 0);
        const bool isCpu = device.info().type == "CPU";
        if (memory == Memory::Host || (isCpu && (device.memoryFlags(type) & mappable) == mappable))
            mapped_ = memory_.mapMemory(0, VK_WHOLE_SIZE);
        // The kernels of a CPU read scenes at random: without huge pages, address translation takes
        // a seventh of their time.
        if (memory == Memory::Device && mapped_)
            adviseHugePages(mapped_, requirements.size);
    });
}

void copyByStaging(const Device& device, std::span<const std::byte> contents, const Buffer& buffer,
                   size_t stagingBytes) {
    const Buffer staging(device, std::min(contents.size(), stagingBytes),
                         vk::BufferUsageFlagBits::eTransferSrc, Buffer::Memory::Host, "staging");
    for (size_t offset = 0; offset < contents.size(); offset += staging.bytes()) {
        const size_t bytes = std::min(staging.bytes(), contents.size() - offset);
        std::memcpy(staging.mapped<std::byte>().data(), contents.data() + offset, bytes);
        device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
            commands.copyBuffer(staging.handle(), buffer.handle(),
                                vk::BufferCopy(0, offset, bytes));
            showWritten(commands);
        });
    }
}

void overwrite(const Device& device, std::span<const std::byte> contents, const Buffer& buffer) {
    if (buffer.mapped<std::byte>().empty())
        copyByStaging(device, contents, buffer);
    else
        std::ranges::copy(contents, buffer.mapped<std::byte>().begin());
}

Buffer uploadBuffer(const Device& device, std::span<const std::byte> contents,
                    vk::BufferUsageFlags usage, const std::string& name) {
    using Usage = vk::BufferUsageFlagBits;
    Buffer buffer(device, contents.size(), usage | Usage::eTransferDst, Buffer::Memory::Device,
                  name);
    overwrite(device, contents, buffer);
    return buffer;
}

Buffer zeroedBuffer(const Device& device, size_t bytes, const std::string& name) {
    Buffer buffer(device, bytes,
                  vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferDst,
                  Buffer::Memory::Device, name);
    clear(device, buffer);
    return buffer;
}

void clear(const Device& device, const Buffer& buffer) {
    device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
        commands.fillBuffer(buffer.handle(), 0, VK_WHOLE_SIZE, 0);
        showWritten(commands);
    });
}

TexelBuffer::TexelBuffer(const Device& device, std::span<const std::byte> contents,
                         const std::string& name)
    : buffer_(uploadBuffer(device, checkRows(device, contents, name),
                           vk::BufferUsageFlagBits::eUniformTexelBuffer, name)) {
    callVulkan([&] {
        view_ = device.handle().createBufferView(
            {{}, buffer_.handle(), vk::Format::eR32G32B32A32Uint, 0, VK_WHOLE_SIZE});
        device.setName(view_, name);
    });
}

} // namespace calotype
