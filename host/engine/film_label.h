#pragma once

#include <filesystem>
#include <string>

#include "film/film_file.h"
#include "gpu/device_info.h"
#include "scene/scene.h"
#include "settings/render_settings.h"

namespace calotype {

/// What a film of these settings is labelled with: all of them that change its samples.
FilmLabel labelOf(const Scene& scene, const RenderSettings& settings);

/// Reads a film; its label is as this version would write it, whichever version wrote the film.
/// Throws SceneError as readFilm.
KeptFilm readLabelledFilm(const std::filesystem::path& path);

/// "llvmpipe (LLVM 15.0.6, 256 bits), llvmpipe Mesa 22.3.6": as films name a device.
std::string nameWithDriver(const DeviceInfo& device);

} // namespace calotype
