#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "denoise/denoised_error.h"
#include "engine/render_plan.h"
#include "read/load.h"
#include "render/render_totals.h"
#include "scene/scene.h"
#include "settings/device_options.h"
#include "settings/render_settings.h"

namespace calotype {

struct RenderJob;

/// Callbacks of a running render. Each may be empty. They are called on the thread that called
/// Renderer::render; an exception from one ends the render.
struct RenderCallbacks {
    /// Called about ten times a second with the current step, such as "building the BVH",
    /// "rendering" or "denoising", and its share done in [0, 1].
    std::function<void(const std::string& what, double done)> onProgress = {};
    /// Called once, when everything is read, built and compiled, before the first file is written.
    std::function<void()> onPrepared = {};
    /// The numbers of the step "rendering": called when sampling starts, then before each
    /// onProgress of that step, and with those of all samples before denoising.
    std::function<void(const RenderPlan& plan, const RenderTotals& totals)> onSamples = {};
    /// Called about ten times a second. If it returns true, the render ends, and the result holds
    /// the samples so far.
    std::function<bool()> shouldStop = {};
    /// Called with each warning of the render: a complete sentence. The warnings of the scene are
    /// in Scene::warnings.
    std::function<void(const std::string& warning)> onWarning = {};
};

/// A rendered picture.
struct RenderResult {
    uint32_t width = 0; ///< pixels: that of RenderSettings::crop, or of the whole picture
    uint32_t height = 0;
    /// 3 * width * height floats: row by row from the top left, red, green and blue of each pixel:
    /// linear radiance with Rec. 709 primaries, W/(m^2 sr). Finite; black if there is no sample.
    std::vector<float> pixels;
    /// With TransportSettings::hidesBackground, the alpha of each pixel, in [0, 1], by which its
    /// colour in `pixels` is multiplied already; else empty.
    std::vector<float> alpha;
    RenderEnding ending = RenderEnding::AllSamples;
    RenderPlan plan;
    /// Samples, rays, seconds and the error, which has no value if the samples are too few (below
    /// 32) or the picture is black.
    RenderTotals totals;
    bool isDenoised = false;
    /// The error of the picture after denoising; none without it, or where nobody can state it: for
    /// fewer than 128 samples per pixel, or if the estimate in `totals` is not to be trusted.
    std::optional<DenoisedError> denoised;
    std::string whyUnstated; ///< why a denoised picture has no such error
    /// The exposure of PNGs where DisplayTransform leaves it to the picture.
    std::optional<float> exposureStops;
    std::vector<std::string> warnings; ///< of the scene and of the render: complete sentences
};

/// Renders a scene on a Vulkan device, or with the reference tracer on the CPU.
///
///     calotype::Renderer renderer(calotype::loadScene("atelier.json"));
///     calotype::RenderSettings settings = renderer.defaultSettings();
///     settings.samplesPerPixel = 64;
///     const calotype::RenderResult result = renderer.render(settings);
///
/// Prints nothing, and changes nothing in the process; compiled kernels are stored in
/// DeviceOptions::cacheFolder. One object must be used by one thread at a
/// time; several objects may be used by several threads. Errors are those of base/error.h.
class Renderer {
public:
    /// loadScene has already checked the scene. The first `render` opens the device; later ones
    /// also use the kernels that it compiled.
    explicit Renderer(LoadedScene scene, DeviceOptions device = {});
    /// Checks a scene that was made in memory, or changed after loading, like one from a file:
    /// throws SceneError, and adds the warnings that the scene lacks.
    explicit Renderer(Scene scene, DeviceOptions device = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    const Scene& scene() const;

    /// The whole picture, with the scene's own size, samples, bounces, seed, denoiser and hidden
    /// background, and the choice of lights that fits their number. The crop is empty, so that the
    /// picture is whole also if its size is changed.
    RenderSettings defaultSettings() const;

    /// Renders the picture. The same settings give the same pixels, bit for bit on one device,
    /// unless a time or a stop ends the render. Throws SettingError if a setting is out of its
    /// range or does not fit the others or the scene, SceneError if the scene exceeds the range of
    /// a device's arithmetic, GpuError if the device or its driver fails, and Interrupted if it is
    /// stopped before sampling starts.
    RenderResult render(const RenderSettings& settings, const RenderCallbacks& callbacks = {});

    /// Also reads and writes the files of the job (engine/render_job.h). If an output cannot be
    /// written, the others still are; then throws OutputError.
    RenderResult render(const RenderJob& job, const RenderCallbacks& callbacks = {});

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace calotype
