#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "read/load.h"
#include "scene/scene.h"
#include "settings/device_options.h"
#include "settings/render_settings.h"

namespace calotype {

/// What a render reports while it runs. Every function may be empty; they are called on the thread
/// that called Renderer::render, and what they throw ends the render.
struct RenderCallbacks {
    /// What is being done, such as "building the BVH" or "rendering", and the share of it done in
    /// [0, 1]; about ten times a second.
    std::function<void(const std::string& what, double done)> onProgress = {};
    /// Called about ten times a second. Once it returns true the render ends, and the result holds
    /// the samples so far.
    std::function<bool()> shouldStop = {};
};

/// Why a render ended.
enum class RenderEnd : uint8_t { AllSamples, TargetError, Time, Stopped };

/// A rendered picture.
struct RenderResult {
    uint32_t width = 0; ///< pixels: those of RenderSettings::crop
    uint32_t height = 0;
    /// 3 * width * height floats: row by row from the top left, in each pixel red, green and blue:
    /// linear radiance with Rec. 709 primaries, W/(m^2 sr). Finite; black where there is no sample.
    std::vector<float> pixels;
    uint64_t samplesPerPixel = 0; ///< that every pixel has; of adaptive sampling the mean
    RenderEnd end = RenderEnd::AllSamples;
    double seconds = 0.0; ///< of sampling, wall-clock time
    /// Relative error of the picture at 95 % confidence, 0.02 for 2 %; none where the samples are
    /// too few (below 32) or the picture is black.
    std::optional<double> relativeError;
    /// False where the error rests on rare bright samples, so that light may be missing.
    bool isErrorTrusted = false;
    std::vector<std::string> warnings; ///< about the scene and the samples: complete sentences
};

/// Renders a scene on a Vulkan device, or with the reference tracer on the CPU.
///
///     calotype::Renderer renderer(calotype::loadScene("atelier.json"));
///     calotype::RenderSettings settings = renderer.defaultSettings();
///     settings.samplesPerPixel = 64;
///     const calotype::RenderResult result = renderer.render(settings);
///
/// Prints nothing, and changes nothing of the process; compiled kernels are kept in
/// $XDG_CACHE_HOME/calotype, or else ~/.cache/calotype. One object is used by one thread at a time;
/// several objects may be used by several threads. Errors are those of base/error.h.
class Renderer {
public:
    /// Takes a scene that was loaded, or made in memory; the latter is checked as one from a file
    /// is: throws SceneError. The device is opened by `render`.
    explicit Renderer(Scene scene, DeviceOptions device = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    const Scene& scene() const;

    /// All of the picture, with the scene's own size, samples, bounces and seed.
    RenderSettings defaultSettings() const;

    /// Renders the picture. The same settings give the same pixels, bit for bit on one device,
    /// unless a time or a stop ends the render. Throws SettingError where a setting is out of its
    /// range, SceneError where the scene does not fit a device's arithmetic, GpuError where the
    /// device or its driver fails, and Interrupted where it is stopped before sampling begins.
    RenderResult render(const RenderSettings& settings, const RenderCallbacks& callbacks = {});

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace calotype
