#pragma once

#include <string>

#include "study/study.h"

namespace calotype {

/// What a page says of where a study came about.
struct StudyOrigin {
    std::string scene; ///< its file
    std::string device;
    std::string command; ///< that renders it: "calotype render scenes/atelier.json"
};

/// A study as one HTML file that needs nothing else: what to choose, the plot, a sentence a
/// variant, and pictures at equal time and at equal error beside their errors in false colours.
std::string toHtml(const Study& study, const StudyOrigin& origin);

} // namespace calotype
