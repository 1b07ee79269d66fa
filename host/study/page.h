#pragma once

#include <string>

#include "study/study.h"

namespace calotype {

/// Where a study was made; shown on the page.
struct StudyOrigin {
    std::string scene; ///< its file
    std::string device;
    std::string command; ///< that renders it: "calotype render scenes/atelier.json"
};

/// A study as one self-contained HTML file: recommended settings, the plot, the effect of each
/// variant, and pictures at equal time and at equal error with their errors in false colours.
std::string toHtml(const Study& study, const StudyOrigin& origin);

} // namespace calotype
