#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "gpu/device.h"
#include "gpu/vulkan.h"

namespace calotype {

/// A buffer with memory of its own.
class Buffer {
public:
    enum class Memory {
        Device, ///< fast for kernels; mapped if the device is a CPU, else accessed by copies
        Host,   ///< always mapped, coherent
    };

    Buffer(const Device& device, size_t bytes, vk::BufferUsageFlags usage, Memory memory,
           const std::string& name);

    vk::Buffer handle() const { return *buffer_; }
    size_t bytes() const { return bytes_; }

    /// The buffer's contents; empty if it is not mapped.
    template <typename T>
    std::span<T> mapped() const {
        return {static_cast<T*>(mapped_), mapped_ ? bytes_ / sizeof(T) : 0};
    }

private:
    size_t bytes_;
    vk::raii::DeviceMemory memory_ = nullptr; // destroyed after the buffer
    vk::raii::Buffer buffer_ = nullptr;
    void* mapped_ = nullptr;
};

/// A buffer on the device that holds `contents`. `usage` needs no transfer flag.
Buffer uploadBuffer(const Device& device, std::span<const std::byte> contents,
                    vk::BufferUsageFlags usage, const std::string& name);

/// Contents of a buffer, one after the other; each starts at the next multiple of 16 bytes.
using BufferParts = std::span<const std::span<const std::byte>>;

/// Overwrites the start of a buffer on the device; the buffer must be a transfer destination.
void overwrite(const Device& device, std::span<const std::byte> contents, const Buffer& buffer);
void overwrite(const Device& device, BufferParts parts, const Buffer& buffer);

/// Copies `parts` to the start of a buffer, a transfer destination, through a mapped buffer of at
/// most `stagingBytes`. overwrite does this if the device's memory is not mapped.
void copyByStaging(const Device& device, BufferParts parts, const Buffer& buffer,
                   size_t stagingBytes = size_t{64} << 20);

/// A storage buffer on the device, all zeros, not accessed by the host.
Buffer zeroedBuffer(const Device& device, size_t bytes, const std::string& name);

/// Sets a zeroedBuffer to zero again.
void clear(const Device& device, const Buffer& buffer);

/// Rows of 16 bytes that kernels fetch. Throws GpuError with the limit if there are more than the
/// device can address.
class TexelBuffer {
public:
    TexelBuffer(const Device& device, BufferParts parts, const std::string& name);
    TexelBuffer(const Device& device, std::span<const std::byte> contents, const std::string& name)
        : TexelBuffer(device, BufferParts(&contents, 1), name) {}

    vk::BufferView view() const { return *view_; }

private:
    Buffer buffer_;
    vk::raii::BufferView view_ = nullptr;
};

} // namespace calotype
