#include "gpu/buffer.h"

#include <algorithm>
#include <cstring>

#include "base/huge_pages.h"

namespace calotype {
namespace {

constexpr size_t kBytesPerRow = 16;

size_t roundedToRows(size_t bytes) {
    return (bytes + kBytesPerRow - 1) / kBytesPerRow * kBytesPerRow;
}

/// Bytes of a buffer that holds all parts.
size_t bytesOf(BufferParts parts) {
    size_t bytes = 0;
    for (const auto& part : parts)
        bytes = roundedToRows(bytes) + part.size();
    return bytes;
}

size_t checkedBytes(const Device& device, BufferParts parts, const std::string& name) {
    const uint64_t bytes = roundedToRows(bytesOf(parts));
    const uint64_t limit = device.limits().maxTexelBufferElements;
    if (bytes / kBytesPerRow > limit)
        throw GpuError("the scene's " + name + " take " + std::to_string(bytes >> 20) +
                       " MiB, and '" + device.info().name + "' can address " +
                       std::to_string((limit * kBytesPerRow) >> 20) + " MiB in one buffer");
    return bytes;
}

/// Copies the bytes of the parts that lie in [begin, begin + window.size()) to the window.
void copyParts(BufferParts parts, size_t begin, std::span<std::byte> window) {
    size_t start = 0;
    for (const auto& part : parts) {
        start = roundedToRows(start);
        const size_t first = std::max(begin, start);
        const size_t last = std::min(begin + window.size(), start + part.size());
        if (first < last)
            std::memcpy(window.data() + (first - begin), part.data() + (first - start),
                        last - first);
        start += part.size();
    }
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

void copyByStaging(const Device& device, BufferParts parts, const Buffer& buffer,
                   size_t stagingBytes) {
    const size_t total = bytesOf(parts);
    const Buffer staging(device, std::min(total, stagingBytes),
                         vk::BufferUsageFlagBits::eTransferSrc, Buffer::Memory::Host, "staging");
    for (size_t offset = 0; offset < total; offset += staging.bytes()) {
        const size_t bytes = std::min(staging.bytes(), total - offset);
        copyParts(parts, offset, staging.mapped<std::byte>().first(bytes));
        device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
            commands.copyBuffer(staging.handle(), buffer.handle(),
                                vk::BufferCopy(0, offset, bytes));
            showWritten(commands);
        });
    }
}

void overwrite(const Device& device, BufferParts parts, const Buffer& buffer) {
    if (buffer.mapped<std::byte>().empty())
        copyByStaging(device, parts, buffer);
    else
        copyParts(parts, 0, buffer.mapped<std::byte>());
}

void overwrite(const Device& device, std::span<const std::byte> contents, const Buffer& buffer) {
    overwrite(device, BufferParts(&contents, 1), buffer);
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

TexelBuffer::TexelBuffer(const Device& device, BufferParts parts, const std::string& name)
    : buffer_(device, checkedBytes(device, parts, name),
              vk::BufferUsageFlagBits::eUniformTexelBuffer | vk::BufferUsageFlagBits::eTransferDst,
              Buffer::Memory::Device, name) {
    overwrite(device, parts, buffer_);
    callVulkan([&] {
        view_ = device.handle().createBufferView(
            {{}, buffer_.handle(), vk::Format::eR32G32B32A32Uint, 0, VK_WHOLE_SIZE});
        device.setName(view_, name);
    });
}

} // namespace calotype
