#include "gpu/storage_image.h"

namespace calotype {
namespace {

constexpr vk::Format kFormat = vk::Format::eR32G32B32A32Sfloat;
constexpr vk::ImageSubresourceRange kWholeImage(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
constexpr vk::ImageSubresourceLayers kColor(vk::ImageAspectFlagBits::eColor, 0, 0, 1);

using Access = vk::AccessFlagBits;
using Layout = vk::ImageLayout;
using Stage = vk::PipelineStageFlagBits;

void barrier(const vk::raii::CommandBuffer& commands, vk::Image image, Stage fromStage,
             vk::AccessFlags from, Stage toStage, vk::AccessFlags to, Layout oldLayout) {
    commands.pipelineBarrier(fromStage, toStage, {}, {}, {},
                             vk::ImageMemoryBarrier(from, to, oldLayout, Layout::eGeneral,
                                                    VK_QUEUE_FAMILY_IGNORED,
                                                    VK_QUEUE_FAMILY_IGNORED, image, kWholeImage));
}

} // namespace

StorageImage::StorageImage(const Device& device, uint32_t width, uint32_t height,
                           const std::string& name)
    : extent_(width, height, 1) {
    const uint32_t limit = device.limits().maxImageDimension2D;
    if (width > limit || height > limit)
        throw GpuError("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                       " pixels is beyond the device's " + std::to_string(limit) +
                       " pixels on a side; render it in parts with --crop");
    callVulkan([&] {
        using Usage = vk::ImageUsageFlagBits;
        image_ = device.handle().createImage(
            {{},
             vk::ImageType::e2D,
             kFormat,
             extent_,
             1,
             1,
             vk::SampleCountFlagBits::e1,
             vk::ImageTiling::eOptimal,
             Usage::eStorage | Usage::eTransferSrc | Usage::eTransferDst});
        device.setName(image_, name);
        const auto requirements = image_.getMemoryRequirements();
        memory_ = device.handle().allocateMemory(
            {requirements.size, device.memoryType(requirements.memoryTypeBits,
                                                  vk::MemoryPropertyFlagBits::eDeviceLocal)});
        image_.bindMemory(*memory_, 0);
        view_ = device.handle().createImageView(
            {{}, *image_, vk::ImageViewType::e2D, kFormat, {}, kWholeImage});
    });
}

void StorageImage::clear(const Device& device) const {
    device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
        barrier(commands, *image_, Stage::eTopOfPipe, {}, Stage::eTransfer, Access::eTransferWrite,
                Layout::eUndefined);
        commands.clearColorImage(*image_, Layout::eGeneral, vk::ClearColorValue(), kWholeImage);
        barrier(commands, *image_, Stage::eTransfer, Access::eTransferWrite, Stage::eComputeShader,
                Access::eShaderRead | Access::eShaderWrite, Layout::eGeneral);
    });
}

void StorageImage::copyFrom(const Device& device, vk::Buffer buffer) const {
    device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
        barrier(commands, *image_, Stage::eTopOfPipe, {}, Stage::eTransfer, Access::eTransferWrite,
                Layout::eUndefined);
        commands.copyBufferToImage(buffer, *image_, Layout::eGeneral,
                                   vk::BufferImageCopy(0, 0, 0, kColor, {}, extent_));
        barrier(commands, *image_, Stage::eTransfer, Access::eTransferWrite, Stage::eComputeShader,
                Access::eShaderRead | Access::eShaderWrite, Layout::eGeneral);
    });
}

void StorageImage::copyTo(const Device& device, vk::Buffer buffer) const {
    device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
        barrier(commands, *image_, Stage::eComputeShader, Access::eShaderWrite, Stage::eTransfer,
                Access::eTransferRead, Layout::eGeneral);
        commands.copyImageToBuffer(*image_, Layout::eGeneral, buffer,
                                   vk::BufferImageCopy(0, 0, 0, kColor, {}, extent_));
        const vk::MemoryBarrier toHost(Access::eTransferWrite, Access::eHostRead);
        commands.pipelineBarrier(Stage::eTransfer, Stage::eHost, {}, toHost, {}, {});
        barrier(commands, *image_, Stage::eTransfer, Access::eTransferRead, Stage::eComputeShader,
                Access::eShaderRead | Access::eShaderWrite, Layout::eGeneral);
    });
}

} // namespace calotype
