#pragma once

#include <cstdint>
#include <string>

#include "gpu/device.h"
#include "gpu/vulkan.h"

namespace calotype {

/// A two-dimensional image of four 32-bit floats per pixel, which kernels read and write. Its
/// layout is always "general".
class StorageImage {
public:
    /// Throws GpuError with the limit if the device does not support this size.
    StorageImage(const Device& device, uint32_t width, uint32_t height, const std::string& name);

    uint32_t width() const { return extent_.width; }
    uint32_t height() const { return extent_.height; }
    vk::ImageView view() const { return *view_; }

    /// Sets every component to zero.
    void clear(const Device& device) const;

    /// Copies the pixels, row by row, from a buffer of width * height * 16 bytes that the host
    /// wrote.
    void copyFrom(const Device& device, vk::Buffer buffer) const;

    /// Copies the pixels, row by row, into a buffer of width * height * 16 bytes.
    void copyTo(const Device& device, vk::Buffer buffer) const;

private:
    vk::Extent3D extent_;
    vk::raii::DeviceMemory memory_ = nullptr; // destroyed after the image
    vk::raii::Image image_ = nullptr;
    vk::raii::ImageView view_ = nullptr;
};

} // namespace calotype
