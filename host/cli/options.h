#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/progress.h"
#include "engine/film_options.h"
#include "engine/output_options.h"
#include "film/block_ranges.h"
#include "film/display_transform.h"
#include "image/layer.h"
#include "read/load.h"
#include "settings/device_options.h"
#include "settings/settings_table.h"

namespace calotype {

struct SceneOptions {
    std::string path;
    std::vector<SceneOverride> overrides;
    MissingTextures missingTextures = MissingTextures::Fail;
    ViewOptions view;
};

struct RenderOptions {
    SceneOptions scene;
    DeviceOptions device;
    GivenSettings settings;
    OutputOptions output;
    FilmOptions film;
    ProgressStyle progress = ProgressStyle::Text;
    bool quiet = false; ///< no progress and no summary
};

struct InfoOptions {
    SceneOptions scene; ///< or a film
    bool asJson = false;
    DeviceOptions device;
    GivenSettings settings;
};

struct DevicesOptions {
    DeviceOptions device;
    bool asJson = false;
};

/// Picture A against picture B.
struct CompareOptions {
    std::string a;
    std::string b;
    std::string differenceFile; ///< empty: none
    std::optional<double> maxRelativeMse;
    bool asJson = false;
};

/// A film, or an EXR picture, to denoise.
struct DenoiseOptions {
    std::string input;
    std::vector<std::string> outputs; ///< pictures
    DisplayTransform display;
    std::string statsFile; ///< empty: none
    GivenSettings settings;
    uint32_t threads = 0; ///< 0: all cores
    bool quiet = false;
};

/// Films to join.
struct MergeOptions {
    std::vector<std::string> films;
    std::vector<std::string> outputs; ///< films, or pictures by their extensions
    DisplayTransform display;
    LayerList layers; ///< of the EXR outputs, beside the picture
    GivenSettings settings;
    uint32_t threads = 0;               ///< of the denoiser; 0: all cores
    std::optional<BlockRange> required; ///< that the films must hold
    bool overwrites = false;            ///< replaces an existing film also by one of fewer samples
    bool asJson = false;                ///< print what the joined film holds as JSON
};

struct StudyOptions {
    SceneOptions scene;
    DeviceOptions device;
    GivenSettings settings;
    double budget = 300.0; ///< seconds, for the whole study
    std::string folder;    ///< empty: by the scene's name
    bool quiet = false;
};

struct BenchOptions {
    std::vector<std::string> scenes; ///< paths; none: generated scenes
    std::vector<SceneOverride> overrides;
    DeviceOptions device;
    GivenSettings settings;
    uint32_t repeats = 5;
    std::string jsonFile; ///< empty: none
};

} // namespace calotype
