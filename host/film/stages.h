#pragma once

#include <span>
#include <string>
#include <vector>

#include "image/picture.h"

namespace calotype {

/// A step that changes a picture in linear light before it is shown or written, such as denoising:
/// a row of the table in stages.cpp. It may change the colour and add channels and metadata.
struct Stage {
    std::string name;                ///< of the option that turns it on, without dashes
    std::string help;                ///< of that option
    std::vector<std::string> layers; ///< whose channels it reads
    void (*run)(Picture& picture) = nullptr;
};

/// Stages, in the order in which they run.
using StageList = std::vector<const Stage*>;

/// The table.
std::span<const Stage> allStages();

} // namespace calotype
