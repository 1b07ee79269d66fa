#include "gpu/pipeline_cache.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "base/atomic_file.h"
#include "base/content_hash.h"

namespace calotype {
namespace {

namespace fs = std::filesystem;

/// Empty if the environment names none.
fs::path defaultFolder() {
    if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder && *folder)
        return fs::path(folder) / "calotype";
    if (const char* home = std::getenv("HOME"); home && *home)
        return fs::path(home) / ".cache" / "calotype";
    return {};
}

/// The name depends on the device, the driver, and the driver's own identifier for its format.
fs::path fileFor(const vk::PhysicalDeviceProperties& properties, const fs::path& folder) {
    if (folder.empty())
        return {};
    char name[64];
    std::snprintf(name, sizeof name, "%04x-%04x-%08x-", properties.vendorID, properties.deviceID,
                  properties.driverVersion);
    std::string text = name;
    for (const uint8_t byte : properties.pipelineCacheUUID) {
        std::snprintf(name, sizeof name, "%02x", byte);
        text += name;
    }
    return folder / (text + ".bin");
}

uint64_t hashOf(std::span<const uint8_t> bytes) {
    ContentHash hash;
    hash.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return hash.value();
}

/// The contents of the file after their hash; empty if the file is missing or damaged, because
/// drivers may crash on data that they did not write.
std::vector<uint8_t> readCache(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
    uint64_t hash = 0;
    if (bytes.size() <= sizeof hash)
        return {};
    std::memcpy(&hash, bytes.data(), sizeof hash);
    const std::vector<uint8_t> data(bytes.begin() + sizeof hash, bytes.end());
    return hash == hashOf(data) ? data : std::vector<uint8_t>();
}

vk::raii::PipelineCache createCache(const vk::raii::Device& device,
                                    const std::vector<uint8_t>& data) {
    return callVulkan([&] {
        return device.createPipelineCache(
            vk::PipelineCacheCreateInfo({}, data.size(), data.data()));
    });
}

} // namespace

PipelineCache::PipelineCache(const vk::PhysicalDeviceProperties& properties,
                             const vk::raii::Device& device, const fs::path& folder)
    : file_(fileFor(properties, folder.empty() ? defaultFolder() : folder)), cache_(nullptr) {
    const std::vector<uint8_t> data = readCache(file_);
    storedBytes_ = data.size();
    cache_ = createCache(device, data);
}

void PipelineCache::store() {
    if (file_.empty())
        return;
    const std::vector<uint8_t> data = callVulkan([&] { return cache_.getData(); });
    if (data.size() <= storedBytes_)
        return;
    const uint64_t hash = hashOf(data);
    std::string bytes(reinterpret_cast<const char*>(&hash), sizeof hash);
    bytes.append(reinterpret_cast<const char*>(data.data()), data.size());
    std::error_code error;
    fs::create_directories(file_.parent_path(), error);
    try {
        writeFileAtomically(file_, bytes);
        storedBytes_ = data.size();
    } catch (const OutputError&) {
        file_.clear(); // works without a file
    }
}

} // namespace calotype
