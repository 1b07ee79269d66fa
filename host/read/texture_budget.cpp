#include "read/texture_budget.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/available_memory.h"
#include "base/error.h"
#include "base/names.h"
#include "scene/texture.h"

namespace calotype {
namespace {

/// Below this no device is opened to ask for its memory.
constexpr uint64_t kFewBytes = uint64_t{64} << 20;

std::string inMebibytes(uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

} // namespace

void TextureBudget::add(const std::string& path, bool isUploaded) {
    const auto [entry, isNew] = entries_.try_emplace(path);
    Entry& counted = entry->second;
    counted.isUploaded = counted.isUploaded || isUploaded;
    if (!isNew)
        return;
    const auto image = sizeOfTexelImage(path);
    constexpr uint32_t kMost = ImageTexture::kLargestSide;
    if (image && image->size.width <= kMost && image->size.height <= kMost) {
        counted.image = *image;
        new_.push_back(path);
    }
}

void TextureBudget::require(const LoadOptions& options) const {
    uint64_t onHost = 0;
    uint64_t onDevice = 0;
    for (const auto& [path, entry] : entries_) {
        onHost += entry.image.bytes();
        onDevice += entry.isUploaded ? entry.image.bytes() : 0;
    }
    if (onHost <= kFewBytes && !options.hostMemory)
        return;
    const DeviceTextureMemory device =
        options.deviceTextureMemory ? options.deviceTextureMemory() : DeviceTextureMemory{};
    if (onDevice > device.bytes)
        throw GpuError("the scene's textures take " + inMebibytes(onDevice) +
                       " on the device, and '" + device.device + "' has room for " +
                       inMebibytes(device.bytes) + largestFiles());
    if (device.isHostMemory)
        onHost += onDevice;
    const uint64_t available = options.hostMemory.value_or(availableMemory());
    if (onHost > available)
        throw Error("the scene's textures take " + inMebibytes(onHost) +
                    " of this machine's memory, and " + inMebibytes(available) + " are available" +
                    largestFiles());
}

std::string TextureBudget::largestFiles() const {
    constexpr size_t kMostNamed = 3;
    std::vector<std::pair<uint64_t, std::string>> files;
    for (const auto& [path, entry] : entries_) {
        const auto& [size, unused] = entry.image;
        files.emplace_back(entry.image.bytes(),
                           inQuotes(std::filesystem::path(path).filename().string()) + " (" +
                               std::to_string(size.width) + " x " + std::to_string(size.height) +
                               ", " + inMebibytes(entry.image.bytes()) + ")");
    }
    std::ranges::stable_sort(files, std::ranges::greater(), &decltype(files)::value_type::first);
    std::string names;
    for (size_t i = 0; i < std::min(kMostNamed, files.size()); ++i)
        names += (i == 0 ? "" : ", ") + files[i].second;
    return "; the largest of " + std::to_string(files.size()) + " files are " + names +
           "; scale textures down";
}

} // namespace calotype
