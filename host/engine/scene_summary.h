#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "math/bounds.h"
#include "read/load.h"
#include "scene/scene.h"
#include "settings/bvh_builder.h"
#include "settings/device_options.h"
#include "settings/render_settings.h"

namespace calotype {

/// Facts about a compiled scene.
struct SceneSummary {
    size_t shapes = 0;
    size_t triangles = 0;
    size_t quadrics = 0; ///< and disks
    size_t materials = 0;
    size_t textures = 0;
    uint64_t textureBytes = 0; ///< on the device
    uint32_t lights = 0;
    uint64_t droppedTriangles = 0; ///< triangles without area, which are left out
    Bounds3d bounds;               ///< metres; empty if no shape has an extent

    BvhBuilder builder = BvhBuilder::Sah;
    size_t nodes = 0;
    double childrenPerNode = 0.0;
    uint32_t depth = 0;
    uint32_t mostDepth = 0; ///< limit of the traversal
    size_t leaves = 0;
    double primitivesPerLeaf = 0.0;
    double nodesVisited = 0.0; ///< by a ray, on average
    double primitivesVisited = 0.0;

    std::vector<std::string> features; ///< of the kernel, by name

    uint64_t sceneBytes = 0;   ///< on a device
    uint64_t largestBytes = 0; ///< in one buffer
};

/// What a device offers for a scene.
struct DeviceFit {
    std::string device;        ///< its name
    std::string reason;        ///< why it was chosen
    uint64_t pictureBytes = 0; ///< of a picture with these settings, without the scene
    uint64_t hostBytes = 0;    ///< of this machine's memory, about, for the picture's samples
    uint64_t memoryBytes = 0;  ///< of the device
    uint64_t bufferBytes = 0;  ///< limit of one buffer
};

/// Compiles the scene for a picture of these settings. Throws SceneError.
SceneSummary summarize(const Scene& scene, const RenderSettings& settings);

/// What the device has for textures. Opens it. Throws GpuError.
DeviceTextureMemory textureMemoryOf(const DeviceOptions& device);

/// Opens the device. Throws GpuError.
DeviceFit fitOf(const RenderSettings& settings, const DeviceOptions& device);

} // namespace calotype
