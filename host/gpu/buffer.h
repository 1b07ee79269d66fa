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
        Device, ///< fast for kernels; mapped where the device is a CPU, else reached by copies
        Host,   ///< mapped for good, coherent
    };

    Buffer(const Device& device, size_t bytes, vk::BufferUsageFlags usage, Memory memory,
           const std::string& name);

    vk::Buffer handle() const { return *buffer_; }
    size_t bytes() const { return bytes_; }

    /// The buffer's contents; empty where they are not mapped.
    template <typename T>
    std::span<T> mapped() const {
        return {static_cast<T*>(mapped_), mapped_ ? bytes_ / sizeof(T) : 0};
    }

private:
    size_t bytes_;
    vk::raii::DeviceMemory memory_ = nullptr; // freed after the buffer
    vk::raii::Buffer buffer_ = nullptr;
    void* mapped_ = nullptr;
};

/// A buffer on the device that holds `contents`. `usage` needs no transfer flag.
Buffer uploadBuffer(const Device& device, std::span<const std::byte> contents,
                    vk::BufferUsageFlags usage, const std::string& name);

/// Overwrites the start of a buffer on the device, a transfer's destination.
void overwrite(const Device& device, std::span<const std::byte> contents, const Buffer& buffer);

/// Copies to the start of a buffer that is a transfer's destination, through a mapped one of at
/// most `stagingBytes`: what overwrite does where the device's memory is not mapped.
void copyByStaging(const Device& device, std::span<const std::byte> contents, const Buffer& buffer,
                   size_t stagingBytes = size_t{64} << 20);

/// A storage buffer on the device, all zeros, for kernels alone.
Buffer zeroedBuffer(const Device& device, size_t bytes, const std::string& name);

/// Makes a zeroedBuffer all zeros again.
void clear(const Device& device, const Buffer& buffer);

/// Rows of 16 bytes for kernels to fetch. Throws GpuError, naming the limit, where there are more
/// than the device can address.
class TexelBuffer {
public:
    TexelBuffer(const Device& device, std::span<const std::byte> contents, const std::string& name);

    vk::BufferView view() const { return *view_; }

private:
    Buffer buffer_;
    vk::raii::BufferView view_ = nullptr;
};

} // namespace calotype
