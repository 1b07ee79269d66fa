#pragma once

#include "engine/render_job.h"
#include "scene/scene.h"
#include "settings/device_options.h"
#include "settings/render_settings.h"

namespace calotype {

/// The whole picture, with the scene's own size, samples, bounces, seed, denoiser and hidden
/// background, the defaultLightChoice, and defaults for the rest.
RenderSettings defaultSettings(const Scene& scene);

/// By power, or by a tree if many primitives emit (docs/accuracy.md, "Light choice").
LightChoice defaultLightChoice(const Scene& scene);

/// Throws SettingError if the device does not support a setting, for any scene.
void requireKnownTo(const DeviceOptions& device, const RenderSettings& settings);

/// Throws SettingError: an adaptive render cannot be given a range of samples.
[[noreturn]] void throwSamplesOfAdaptive();

/// Throws SettingError if a setting is out of its range, or does not fit the others or the device.
void requireRenderable(const RenderSettings& settings, const DeviceOptions& device);

/// Throws UsageError if the files of a job do not fit its settings or each other.
void requireConsistent(const RenderJob& job);

} // namespace calotype
