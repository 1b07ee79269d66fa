#pragma once

#include <filesystem>
#include <string>

#include "film/film_file.h"
#include "gpu/device_info.h"
#include "scene/scene.h"
#include "settings/render_settings.h"

namespace calotype {

/// The label of a film with these settings: all settings that change its samples.
FilmLabel labelOf(const Scene& scene, const RenderSettings& settings);

/// Reads a film. Its label has the form of this version, whichever version wrote the film. Throws
/// SceneError like readFilm.
KeptFilm readLabelledFilm(const std::filesystem::path& path);

/// "llvmpipe (LLVM 15.0.6, 256 bits), llvmpipe Mesa 22.3.6": a device in a film's label.
std::string nameWithDriver(const DeviceInfo& device);

} // namespace calotype
