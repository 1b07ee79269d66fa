#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "film/display_transform.h"
#include "film/stages.h"
#include "image/layers.h"
#include "read/load.h"
#include "settings/bvh_builder.h"
#include "settings/light_choice.h"
#include "settings/render_settings.h"

namespace calotype {

/// When to write a preview: after so many samples, or so many seconds; 0 means never.
struct PreviewInterval {
    uint32_t samples = 0;
    double seconds = 0.0;
};

struct DeviceOptions {
    std::string device;   ///< index or part of a name; empty: choose
    uint32_t threads = 0; ///< of lavapipe; 0: as many as there are cores
};

struct SceneOptions {
    std::string path;
    std::vector<SceneOverride> overrides;
    MissingTextures missingTextures = MissingTextures::Fail;
};

/// Samples of absolute indices from `begin` up to but not including `end`: whole blocks.
struct SampleRange {
    uint32_t begin = 0;
    uint32_t end = 0;
};

/// Films to keep and go on with; empty paths are none.
struct FilmOptions {
    std::string film;
    std::string resume;
    std::optional<double> checkpointSeconds; ///< none: the default

    static constexpr double kCheckpointSeconds = 60.0;
};

struct RenderOptions {
    SceneOptions scene;
    DeviceOptions device;
    std::optional<BvhBuilder> bvh; ///< none: the quickest
    std::vector<std::string> outputs;
    FilmOptions film;
    std::optional<uint32_t> samplesPerPixel;
    std::optional<SampleRange> samples;
    std::optional<double> targetError; ///< the most that ErrorEstimate::upperBound may be
    std::optional<double> seconds;     ///< from the start of the program
    bool adapts = false;               ///< gives samples where the error is
    std::optional<uint32_t> maxBounces;
    std::optional<uint32_t> seed;
    Sampler sampler = Sampler::Sobol;
    TransportSettings transport;
    LightChoice lightChoice = LightChoice::Power;
    std::optional<TextureFilter> textureFilter; ///< none: as each texture says
    std::optional<PictureSize> size;
    std::optional<Crop> crop;
    DisplayTransform display;
    LayerList layers; ///< of the EXR outputs, beside the picture
    StageList stages;
    PreviewInterval previewInterval;
    std::string previewFile; ///< empty: the first output
    std::string statsFile;   ///< empty: none
    bool quiet = false;
};

struct InfoOptions {
    SceneOptions scene; ///< or a film
    bool asJson = false;
    DeviceOptions device;
    std::optional<BvhBuilder> bvh;
};

/// Picture A against picture B, the reference.
struct CompareOptions {
    std::string a;
    std::string b;
    std::string differenceFile; ///< empty: none
    std::optional<double> maxRelativeMse;
};

/// Films to join.
struct MergeOptions {
    std::vector<std::string> films;
    std::vector<std::string> outputs; ///< films, or pictures by their extensions
    DisplayTransform display;
    LayerList layers; ///< of the EXR outputs, beside the picture
    StageList stages;
};

struct StudyOptions {
    SceneOptions scene;
    DeviceOptions device;
    std::optional<PictureSize> size; ///< none: as large as leaves time for a good reference
    double budget = 300.0;           ///< seconds, for all of it
    std::string folder;              ///< empty: by the scene's name
    bool quiet = false;
};

struct BenchOptions {
    std::vector<std::string> scenes; ///< paths; none: scenes made for it
    std::vector<SceneOverride> overrides;
    DeviceOptions device;
    std::optional<BvhBuilder> bvh; ///< none: the quickest for all repeats together
    Sampler sampler = Sampler::Sobol;
    uint32_t samplesPerPixel = 4; ///< of each repeat
    uint32_t repeats = 5;
    bool compilesEverything = false; ///< whatever of the kernel the scene needs
    std::string jsonFile;            ///< empty: none
};

} // namespace calotype
