#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "film/display_transform.h"
#include "image/layer.h"

namespace calotype {

/// When to write a preview: after this many samples, or this many seconds; 0 means never.
struct PreviewInterval {
    uint32_t samples = 0;
    double seconds = 0.0;
};

/// The files that a render writes, beside its film.
struct OutputOptions {
    std::vector<std::string> pictures; ///< their extensions name the format
    DisplayTransform display;          ///< of PNG
    LayerList layers;                  ///< of EXR, beside the picture
    PreviewInterval previewInterval;
    std::string previewFile; ///< empty: the first picture
    std::string statsFile;   ///< empty: none
};

} // namespace calotype
